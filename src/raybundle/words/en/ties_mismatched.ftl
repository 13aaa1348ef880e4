# $pairs = 1
# $ids = ["t1", "t2"]
ties_mismatched = { $pairs } { $pairs ->
        [one] pair
       *[other] pairs
     } of rejected tie points { $pairs ->
        [one] was
       *[other] were
     } matched with one another: { $ids }.
