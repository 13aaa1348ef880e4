length_test-no_length = Eine Längenprüfung braucht mindestens eine bekannte Länge.

length_test-no_scale = { $name }: Keine Beobachtung bestimmt den Maßstab; Längen haben keine Einheit.
    .do = Eine Maßstabsstrecke angeben.

length_test-invalid_length = Länge { $start } - { $end }: { $length_m } m mit Standardabweichung { $sigma_m } m ist ungültig.
    .do = Eine Länge über 0 zwischen zwei verschiedenen Punkten und eine Standardabweichung von 0 oder mehr angeben.

length_test-no_error = Länge { $start } - { $end } hat keinen Fehler, da beide Enden gehalten sind.
    .why = Sie kann die Messung nicht prüfen.
    .do = Diese Länge weglassen.
