up_uncertain = Die Lotrichtung folgt aus der angenommenen Kamerahaltung und ist auf ± { NUM($sigma_deg, decimals: 0) }° unsicher.
    .do = Zwei gemessene Punkte angeben, B lotrecht über A: { OPTION("up", "A,B") }.
