# $n = 1
# $names = ["IMG_2 (IMG_1)"]
# $ids = ["IMG_2"]
identical_images-copies = { $n } { $n ->
     [one] photograph is a copy of another one, or has no base to it, and is
     *[other] photographs are copies of others, or have no base to them, and are
    } left out: { LIST($names, most: 3) }.
    .why = A copy repeats the noise of its original; standard deviations would be too small.
    .do = If a photograph is no copy, take it again from another position.

# $pairs = 1
identical_images = { $pairs } { $pairs ->
        [one] pair of images has
       *[other] pairs of images have
    } the same image points within half a pixel.
    .why = They are the same photograph twice, or have no base between them.
    .do = Exclude one image of each pair.
