identical_images-copies = { $n } { $n ->
     [one] Aufnahme ist eine Kopie einer anderen oder hat keine Basis zu ihr; weggelassen:
     *[other] Aufnahmen sind Kopien anderer oder haben keine Basis zu ihnen; weggelassen:
    } { LIST($names, most: 3) }.
    .why = Eine Kopie wiederholt das Rauschen ihres Originals; Standardabweichungen würden zu klein.
    .do = Eine Aufnahme, die keine Kopie ist, von einem anderen Standpunkt wiederholen.

identical_images = { $pairs } { $pairs ->
        [one] Bildpaar hat
       *[other] Bildpaare haben
    } auf ein halbes Pixel dieselben Bildpunkte.
    .why = Es ist zweimal dieselbe Aufnahme, oder es fehlt die Basis.
    .do = Von jedem Paar ein Bild ausschließen.
