# $kind = "scale_bar"
# $n = 1
# $ids = ["A1 - A2"]
given_twice = { $kind ->
        [scale_bar] Scale bars
       *[length] Lengths
     } given twice and counted once: { LIST($ids, most: 10) }.
    .why = The result is not affected, because each length counts once.
    .do = Delete the repeated rows.
