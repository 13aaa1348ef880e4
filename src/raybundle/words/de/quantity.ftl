quantity-coincide = Die Punkte fallen zusammen.
    .do = Andere Punkte wählen.

quantity-in_line = Die Punkte liegen auf einer Geraden.
    .do = Andere Punkte wählen.

quantity-not_defined = Die Größe { $quantity } ist durch die Punkte { $names } nicht bestimmt.
    .do = Andere Punkte für diese Größe wählen.

quantity-point_count = { $quantity }: { $n } Punkte sind angegeben; { $most ->
        [0] nötig sind mindestens { $least }
       *[other] möglich sind { $least } bis { $most }
     }.
    .do = Eine andere Zahl von Punkten angeben.

quantity-none = Keine Größe ist verlangt.
    .do = Eine von { LIST($known, most: 20) } angeben.
