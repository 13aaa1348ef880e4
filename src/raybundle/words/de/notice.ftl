notice-also = Dasselbe gilt für { $n } { $n ->
        [one] weiteres Objekt
        *[other] weitere Objekte
    }: { LIST($names, most: 10) }.
