up_uncertain = Die Lotrichtung ist auf ± { NUM($sigma_deg, decimals: 0) }° unsicher: Sie folgt aus der Haltung der Kamera.
    .do = Zwei gemessene Punkte angeben, B lotrecht über A: { OPTION("up", "A,B") }.
