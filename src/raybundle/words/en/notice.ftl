# $n = 3
# $names = ["A1", "A2", "A3"]
notice-also = The same applies to { $n } { $n ->
    [one] more
   *[other] more
 }: { LIST($names, most: 10) }.
