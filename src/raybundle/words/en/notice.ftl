# $n = 3
# $names = ["A1", "A2", "A3"]
notice-also = The same applies to { $n } more { $n ->
        [one] object
        *[other] objects
    }: { LIST($names, most: 10) }.
