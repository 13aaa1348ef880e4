up_ambiguous = Die Lotrichtung ist nicht eindeutig: Der Satz ist nur mit { PERCENT($probability) } % Wahrscheinlichkeit { $kind ->
     [terrestrial] terrestrisch
     [aerial] aus der Luft
     *[oblique] schräg aus der Luft
    } (Grenze { PERCENT($limit) } %).
    .why = Er wird so behandelt, nach der angenommenen Kamerahaltung.
    .do = Liegt das Ergebnis auf der Seite, { OPTION("up", "terrestrial") }, { OPTION("up", "aerial") } oder zwei Punkte angeben, B lotrecht über A: { OPTION("up", "A,B") }.
