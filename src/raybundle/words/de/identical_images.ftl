identical_images-copies = { $n } { $n ->
     [one] Aufnahme ist eine Kopie einer anderen oder hat keine Basis zu ihr; weggelassen:
     *[other] Aufnahmen sind Kopien anderer oder haben keine Basis zu ihnen; weggelassen:
    } { LIST($names, most: 3) }.
    .why = Eine Kopie wiederholt das Rauschen ihres Originals; Standardabweichungen würden zu klein.
