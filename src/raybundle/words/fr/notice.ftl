notice-also = Il en va de même pour { $n } { $n ->
    [one] autre
   *[other] autres
 } : { LIST($names, most: 10) }.
