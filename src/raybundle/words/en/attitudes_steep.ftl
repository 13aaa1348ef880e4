# $n = 2
# $ids = ["IMG_1", "IMG_2"]
attitudes_steep = { $n } { $n ->
     [one] attitude is
     *[other] attitudes are
    } not used: { $ids }.
    .why = These photographs look along the X axis, where omega and kappa rotate about the same axis.
