position_left_out = Die Position von { $image } widerspricht den anderen um { $distance } m und wird nicht verwendet.
    .do = Ihre Koordinaten, ihren Namen und die Lösung des Empfängers prüfen.
