unusual_errors = Ungewöhnlich große Verbesserungen: { NUM($rms_px, digits: 2) } px (Grenze { $limit_rms_px }), glatter Anteil { NUM($smooth_px, digits: 2) } px (Grenze { $limit_smooth_px }).
    .why = Wahrscheinliche Ursachen: ein falsches Kameramodell (Fischauge), mehrere Kameras oder Brennweiten als eine Kamera, eine bewegte Szene, ein Rolling Shutter oder bearbeitete Aufnahmen.
    .do = Die Verbesserungen einzelner Bilder und eine Länge oder Kontrollpunkte prüfen.
