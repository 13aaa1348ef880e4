notice-also = Dasselbe gilt für { $n } { $n ->
    [one] weiteren
   *[other] weitere
 }: { LIST($names, most: 10) }.
