# $n = 3
# $names = ["IMG_4", "IMG_5", "IMG_6"]
# $photograph = "IMG_4"
# $other = "IMG_3"
# $matches = 2900
# $plain = 91
mirrored_photographs = { $n } { $n ->
        [one] photograph is
        *[other] photographs are
    } mirrored against the others and left out: { LIST($names, most: 3) }.
    .why = { $photograph } has { $matches } matches with { $other } if left and right are exchanged, and at most { $plain } unchanged.
    .do = Exchange left and right in an image editor, or scan the slides from the other side.

# $n = 3
# $names = ["IMG_4", "IMG_5", "IMG_6"]
# $photograph = "IMG_4"
# $other = "IMG_3"
# $matches = 900
# $plain = 300
mirrored_photographs-possible = { $n } { $n ->
        [one] photograph may be
        *[other] photographs may be
    } mirrored against the others: { LIST($names, most: 3) }.
    .why = { $photograph } has { $matches } matches with { $other } if left and right are exchanged, and at most { $plain } unchanged. A symmetrical object explains it as well, so they are not left out.
    .do = Compare the photographs with the object. Exchange left and right of those that are mirrored, and run again.

# $n = 2
# $names = ["IMG_4", "IMG_5"]
mirrored_photographs-stored = { $n } { $n ->
        [one] photograph is
        *[other] photographs are
    } stored mirrored, by EXIF orientation: { LIST($names, most: 3) }.
    .why = Pixels are measured as stored, so the object is mirrored.
    .do = Save the photographs the right way round, as they were exposed.
