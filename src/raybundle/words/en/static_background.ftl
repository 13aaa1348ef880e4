# $n = 8
# $share = 0.4
# $masked = false
# $ids = ["IMG_1", "IMG_2"]
static_background = In { $n } photographs { PERCENT($share) } % of the matches are at the same pixels, while others move.
    .why = A background, watermark or date does not turn with the object; the result follows one of the two.
    .do = { $masked ->
     [yes] Extend the masks over all of it, or photograph in front of a background without texture
     *[no] Mask it with { OPTION("masks", "DIR") }, or photograph in front of a background without texture
    }.
