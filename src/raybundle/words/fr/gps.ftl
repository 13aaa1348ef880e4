gps = Les positions de { $n } photographie(s) sont observées{ $flights ->
     [0] { "" }
     [one] { "" }, avec un décalage commun estimé
     *[other] { "" }, avec un décalage estimé pour chacun des { $flights } vols
    }.
