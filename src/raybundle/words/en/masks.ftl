# $n = 12
# $photographs = 20
# $of = "features"
# $missing = 8
# $ids = ["a.jpg", "b.jpg"]
masks = { $n } of { $photographs } photographs have a mask; { $of ->
        [features] features are detected
       *[depths] depths are measured
    } only where it is not black.
    .why = { $missing ->
        [0] {""}
       *[other] Without a mask and used completely: { $missing } ({ LIST($ids, most: 3) }).
    }
