position_left_out = Die Position von { $image } widerspricht den anderen um { $distance } m und wird nicht verwendet.
    .do = Koordinaten und Namen der Position und die Lösung des Empfängers prüfen.
