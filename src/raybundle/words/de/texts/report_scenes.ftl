report_scenes-title = Satellitenszenen

report_scenes-strips_title = Streifen von Zeilenkameras

report_scenes-scenes = { $n } { $n ->
        [one] Szene
        *[other] Szenen
    } mit der Geometrie des Anbieters.
    .why = Die Tabelle enthält die Korrekturen der Ausgleichung.

report_scenes-bias = Ein Bias wird zur Abbildung addiert, in Pixeln der Szene.

report_scenes-maps = Karten und Abbildungen des Netzes zeigen eine Szene nahe am Gelände, in ihrer Blickrichtung.

report_scenes-sigma_of_scenes = σ, angegeben: vor der Ausgleichung bekannt, etwa ERR_BIAS des Anbieters.

report_scenes-marked = Hervorgehoben: mehr als das Dreifache des angegebenen σ.
    .do = Datei, Passpunkte und deren Koordinatensystem prüfen.

report_scenes-strips = { $n } { $n ->
        [one] Streifen
        *[other] Streifen
    } von Zeilenkameras mit Zeilen, deren Lage GNSS und INS liefern.

report_scenes-corrections = Korrekturen der Ausgleichung: in Flugrichtung, quer dazu, in der Höhe und um die Achsen der Zeile.

report_scenes-further_parameters = Soweit geschätzt, folgen der Versatz der Uhren und der Hebelarm.

report_scenes-sigma_of_strips = σ, angegeben: der Positionen und Drehungen in ihrer Tabelle; –: unbekannt, etwa für die Fehlausrichtung des INS.

report_scenes-every_parameter = Alle Parameter

report_scenes-name = { $kind ->
        [strip] Streifen
        *[scene] Szene
    } { $name }

report_scenes-kind = { $kind ->
        [strip] Streifen
        *[scene] Szene
    }

report_scenes-figures_drawn = Abbildungen gibt es zu { $n } von { $of } { $kind ->
        [strip] Streifen
        *[scene] Szenen
    }.

report_scenes-on_ground = am Boden

report_scenes-value_by_sigma = Wert / angegebenes σ

report_scenes-model = { $strip ->
        [yes] GNSS und INS
        *[no] Bahn und Lage
    }

report_scenes-range_doppler = Bahn, Entfernung und Doppler

report_scenes-along_track = in Flugrichtung

report_scenes-trend = Die mittlere Verbesserung ändert sich mit der Zeile (Wahrscheinlichkeit durch Zufall unter { PERCENT($level) } %):

report_scenes-wave = { $name } in { $axis } um bis zu { NUM($size_px, digits: 2) } px.

report_scenes-more_waves = { $n } weitere.

report_scenes-cause = { $kind ->
        [scene] Mögliche Ursachen: Jitter der Lage oder eine Drift, die dem Bias fehlt.
        *[strip] Mögliche Ursache: Bewegungen des Flugzeugs zwischen den Stützstellen.
    }
    .do = { $kind ->
            [scene] Den Bias „drift“ wählen, bei einer strengen Szene eine Kurve.
            *[strip] Mehr Stützstellen schätzen.
        }

report_scenes-no_trend = Keine mittlere Verbesserung ändert sich signifikant mit der Zeile: Jitter ist nicht sichtbar.

report_scenes-hidden = nicht sichtbar

report_scenes-two_rays = Die meisten Punkte liegen in nur zwei { $kind ->
        [strip] Streifen
        *[scene] Szenen
    }.
    .why = Ein Fehler in der Ebene ihrer zwei Strahlen ändert Höhen und hinterlässt keine Verbesserung.

report_scenes-jitter_in_heights = Jitter in Flugrichtung eines Stereopaars ist deshalb nur zum Teil sichtbar.

report_scenes-residuals = Verbesserungen, RMS { $rms_px } px; Vektoren: { NUM($length_px, digits: 1) } px sind als { $drawn_px } px dieser Seite gezeichnet.

report_scenes-bias_map = Bias über der Szene, { $constant ->
        [yes] konstant
        *[no] veränderlich
    }; er wird zur Abbildung des RPC addiert.
    .why = Der Punkt ist der Anfang eines Vektors.

report_scenes-track = Verbesserungen in { $axis } in Flugrichtung und ihr gleitendes Mittel; Band: 95 % ohne Trend.

report_scenes-no_jitter_plot = Kein RPC kann diese Szene ersetzen, und Jitter ist nicht gezeichnet:

report_scenes-no_jitter = Das ausgeglichene strenge Modell enthält keinen Jitter: Ein RPC stimmt mit ihm auf { $limit_px } px überein (RMS).

report_scenes-jitter = Strenges Modell minus sein RPC, Mittel über die Spalten: RMS { NUM($x_px, digits: 2) } px in x, { NUM($y_px, digits: 2) } px in y.
    .why = Ein RPC ist für Jitter zu glatt; dies sind seine Restfehler.

report_scenes-correction = Korrektur, { $quantity ->
        [position_along_track] Position in Flugrichtung
        [position_across_track] Position quer zur Flugrichtung
        [height] Höhe
        [attitude_about_x] Drehung um x
        [attitude_about_y] Drehung um y
        *[attitude_about_z] Drehung um z
    }: höchstens { NUM($largest, digits: 2) } { $unit ->
        [units] Einheiten
        *[other] { $unit }
    } vom Mittel.
    .why = Mittel: { NUM($mean, digits: 5) }{ $known ->
            [yes] {" "}± { NUM($sigma, digits: 2) }
            *[no] {""}
        } { $unit ->
            [units] Einheiten
            *[other] { $unit }
        }{ $banded ->
            [yes] ; Band: 1 σ.
            *[no] .
        }

report_scenes-push_frame = Push-Frame

report_scenes-optical_bar = Optical Bar
