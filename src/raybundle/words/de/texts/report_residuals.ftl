report_residuals-title = Verbesserungen der Bildbeobachtungen

report_residuals-none = Es gibt keine verwendete Bildbeobachtung.

report_residuals-rms = Verbesserungen (RMS): { $x_px } px in x, { $y_px } px in y; die größte ist { $largest_px } px.

report_residuals-definition = Eine Verbesserung ist ausgeglichen minus beobachtet, im Pixelsystem (y nach unten).

report_residuals-histogram = Normierte Verbesserungen { $symbol } von { $n } Bildkoordinaten und die Normalverteilung.
    .why = Über 3,29 liegen { $beyond } (erwartet { NUM($expected, digits: 2) }); Exzess { NUM($kurtosis, decimals: 2) }.

report_residuals-quantiles = Ihre Quantile gegen die der Normalverteilung: auf der Geraden, wenn Fehler normalverteilt sind.
    .why = Steilere Enden bedeuten mehr große Verbesserungen als bei einer Normalverteilung.

report_residuals-systematic_of = Systematischer Anteil, Kamera { $camera }

report_residuals-cells = Mittlere Verbesserungen in Zellen des Formats, mit der Zahl der Punkte.
    .why = Schattierte Zellen: Das Mittel weicht von null ab ({ PERCENT($level) } % für alle Zellen zusammen; { $white ->
            [yes] Verbesserungen als unkorreliert angenommen
            *[no] aus der Streuung einzelner Aufnahmen
        }).

report_residuals-profile = Mittlere radiale (nach außen) und tangentiale Verbesserung in Ringen gleicher Punktzahl.
    .why = Balken: Standardabweichung jedes Mittels. Ein Trend ist Verzeichnung, die dem Modell fehlt.

report_residuals-too_few_points = Für Mittelwerte gibt es zu wenige Punkte.

report_residuals-cell_tests = Mittlere Verbesserung in { $n } von { $of } Zellen ungleich null: { $verdict ->
        [none] kein signifikanter systematischer Anteil
        [systematic] systematischer Anteil nach dem Kameramodell
        *[small] stellenweise kleiner systematischer Anteil
    }.

report_residuals-cell_means = Zellmittel: RMS { NUM($rms_px, digits: 2) } px ({ PERCENT($share) } % der Verbesserungen, RMS), größtes { NUM($largest_px, digits: 2) } px.

report_residuals-images = Bilder

report_residuals-rms_of_images = Verbesserungen jedes Bildes (RMS); gestrichelt: aller Bilder, { $rms_px } px.

report_residuals-scale = Maßstab der Vektoren.

report_residuals-vectors = Vektoren der Verbesserungen von { $n } { $n ->
        [one] Bild
        *[other] Bildern
    }

report_residuals-table = Verbesserungen jedes Bildes als Tabelle

report_residuals-vectors_order = Vektoren der Verbesserungen jedes Bildes mit ihrem RMS, der größte RMS zuerst.

report_residuals-images_drawn = Gezeichnet sind { $n } von { $of } Bildern.

report_residuals-vectors_drawn = Gezeichnet sind höchstens { $n } Vektoren eines Bildes, darunter die größten.

report_residuals-crossed = Ein Kreuz kennzeichnet einen verworfenen Punkt.

report_residuals-vectors_of_image = { $image }, { NUM($rms_px, decimals: 3) } px RMS von { $n } { $n ->
        [one] Punkt
        *[other] Punkten
    }{ $rejected ->
        [0] {""}
        *[other] ; { $rejected } verworfen
    }

report_residuals-largest_w = größtes |w| / σ₀

report_residuals-mean_r = mittleres r

report_residuals-differs = weicht von den anderen ab

report_residuals-differs_note = σ eines Bildes mit „weicht ab“ ist nicht das des ganzen Bildverbands (Niveau je { PERCENT($level) } %).
