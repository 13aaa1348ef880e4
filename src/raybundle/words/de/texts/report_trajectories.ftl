report_trajectories-title = Beobachtete Positionen und Drehungen

report_trajectories-carried = Hebelarme, Versätze, Driften und Fehlausrichtungen

report_trajectories-line = { $kind ->
        [antenna] Antenne { $name }
        [positions] Positionen
        *[attitudes] Drehungen
    }, { $n } { $n ->
        [one] Bild
        *[other] Bilder
    }

report_trajectories-lines_drawn = { $n } von { $of } Streifen sind gezeichnet.

report_trajectories-observed = Beobachtet: { $positions } { $positions ->
        [one] Position
        *[other] Positionen
    }, { $attitudes } { $attitudes ->
        [one] Drehung
        *[other] Drehungen
    }.

report_trajectories-methods = Die direkte Orientierung verwendet sie unverändert, die integrierte gleicht sie mit den Bildpunkten aus.

report_trajectories-difference = Ihre Differenz, beobachtet minus ausgeglichen, enthält die Fehler von GNSS und INS.
    .why = Sie enthält auch verbliebene Fehler von Hebelarm, Fehlausrichtung und Uhren.

report_trajectories-component = { $component ->
        [east] Ost
        [north] Nord
        [height] Höhe
        *[other] { $component }
    }

report_trajectories-component_label = Komponente

report_trajectories-sigma_after = σ nach der Ausgleichung

report_trajectories-comparison = Direkte minus integrierte Orientierung

report_trajectories-corrected = Nach Hebelarm, Versatz, Drift und Fehlausrichtung, soweit sie geschätzt sind.

report_trajectories-marked = Hervorgehoben: Der RMS übersteigt das Doppelte des angegebenen σ.

report_trajectories-sigma_after_note = σ nach der Ausgleichung: des integrierten Werts, im Datum des Bildverbands.

report_trajectories-carrier = Instrument

report_trajectories-separability = Bei Senkrechtaufnahmen gleicher Flugrichtung sind Hebelarm und Versatz nicht trennbar.
    .why = Einen konstanten Fehler der Drehung nimmt die Fehlausrichtung auf.

report_trajectories-along_line = Beobachtet minus ausgeglichen, { report_trajectories-component }, RMS { $rms } { $unit ->
        [units] Einheiten
        *[other] { $unit }
    }; Band: 95 % nach der angegebenen Standardabweichung.

report_trajectories-motion = { $kind ->
        [velocity] Geschwindigkeit
        *[rotation] Drehung
    } während des Auslesens jedes Bildes, in der Reihenfolge des Bildverbands, und ihr σ.

report_trajectories-motion_heading = Bewegung während des Auslesens

report_trajectories-shift = Versatz: beobachtete minus ausgeglichene Position, in X, Y, Z.
    .why = Mit Koordinaten einer Karte sind das Ost, Nord und oben.
