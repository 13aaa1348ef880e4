calibration_contradicted = Kamera { $camera }: Die Aufnahmen widersprechen der Kalibrierung (Chi-Quadrat { NUM($squares, decimals: 0) }, Grenze { NUM($limit, decimals: 1) }).
    .why = Fokussierung, Brennweite oder Einbau war anders{ $smooth ->
        [yes] , oder die Aufnahmen haben glatte Fehler, die ihre Gewichte nicht enthalten
       *[no] { "" }
     } ({ $n } Parameter, { $level_percent } %).
    .do = Unter den Bedingungen der Aufnahmen kalibrieren oder die Kalibrierung festhalten (estimate = []).

calibration_contradicted-held = Kamera { $camera }: Die Aufnahmen widersprechen der festgehaltenen Kalibrierung (F { $F }, Grenze { $limit }).
    .why = Die Kalibrierung verschiebt Bildpunkte um bis zu { NUM($effect_px, digits: 2) } px (Sigma { NUM($sigma_px, digits: 2) } px) und Projektionszentren signifikant (F { NUM($centres, digits: 3) }, Grenze { NUM($centres_limit, digits: 3) }; { $n } Parameter, { $level_percent } %).
    .do = Prüfen, ob die Kalibrierung zu Kamera, Fokussierung, Brennweite und Format gehört; wenn ja, ihre Standardabweichungen oder estimate = "auto" angeben, sonst sie weglassen.

calibration_contradicted-harmless = Kamera { $camera }: Die Aufnahmen widersprechen der festgehaltenen Kalibrierung (F { $F }, Grenze { $limit }).
    .why = Die Kalibrierung verschiebt Bildpunkte um bis zu { NUM($effect_px, digits: 2) } px (Sigma { NUM($sigma_px, digits: 2) } px), Projektionszentren aber nicht signifikant (F { NUM($centres, digits: 3) }, Grenze { NUM($centres_limit, digits: 3) }; { $n } Parameter, { $level_percent } %); die Kalibrierung kann die bessere sein.
    .do = Kontrollpunkte oder Längen vergleichen.

calibration_contradicted-given = Parameter { $symbol }: angegeben { NUM($given, digits: 9) } { $unit }, gefunden { NUM($found, digits: 9) } { $unit } (|w| { NUM($w, decimals: 1) }, Grenze { NUM($limit, decimals: 1) }{ $alone ->
        [yes] { "" }
        *[no] ; nur alle Parameter zusammen überschreiten ihre Grenze
    }).
    .do = Den angegebenen Wert mit dem Kalibrierschein vergleichen.

calibration_contradicted-moved = Parameter { $symbol }: festgehalten { NUM($given, digits: 9) } { $unit }, gefunden { NUM($found, digits: 9) } ± { NUM($sigma, digits: 2) } { $unit } ({ NUM($effect_px, digits: 2) } px; |w| { NUM($w, decimals: 1) }, Grenze { NUM($limit, decimals: 1) }{ $alone ->
        [yes] { "" }
        *[no] ; nur alle Parameter zusammen überschreiten ihre Grenze
    }).
    .do = Den festgehaltenen Wert mit dem Kalibrierschein vergleichen.
