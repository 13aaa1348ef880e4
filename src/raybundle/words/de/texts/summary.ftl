summary-adjusted = Ausgeglichen: { $images } { $images ->
        [one] Bild
        *[other] Bilder
    }, { $points } { $points ->
        [one] Objektpunkt
        *[other] Objektpunkte
    }, { $observations } Bildbeobachtungen{ $rejected ->
        [0] {""}
        *[other] , davon { $rejected } verworfen
    }.

summary-accuracy_of_check_points = Genauigkeit an { $n } { $n ->
        [one] Kontrollpunkt
        *[other] Kontrollpunkten
    }: { NUM($rms, digits: 2) } { $unit } (RMS einer Koordinate).

summary-precision = Standardabweichung der Objektpunkte: { $few ->
        [yes] { NUM($median, digits: 2) } { $unit } (Median einer Koordinate; RMS { NUM($rms, digits: 2) })
        *[no] { NUM($rms, digits: 2) } { $unit } (RMS einer Koordinate)
    }{ $free_scale ->
        [yes] , Maßstab willkürlich
        *[no] {""}
    }.

summary-no_statistics = Keine Standardabweichungen: die Statistik ist abgeschaltet.

summary-no_object_points = Kein Objektpunkt wird geschätzt.

summary-counts = Verwendet: { $images } von { $images_given } Bildern, { $points } von { $points_given } Objektpunkten, { $observations } von { $observations_given } Beobachtungen.
    .why = { $rejected ->
            [0] {""}
            *[other] Verworfene Beobachtungen: { $rejected } (observations.csv).
        }

summary-sigma0 = { $known ->
        [yes] sigma0 = { NUM($sigma0, digits: 4) }
        *[no] sigma0 ist nicht schätzbar
    }, a priori { $sized ->
        [yes] { NUM($sigma_um, digits: 2) } um =
        *[no] {""}
    } { NUM($sigma_px, digits: 2) } px{ $one ->
        [yes] {""}
        *[no] {" "}(Median)
    }, Redundanz { $redundancy }.

summary-datum = Datum: { $datum }.

summary-precision_of_axes = Standardabweichung der Objektpunkte (RMS): X { $x }, Y { $y }, Z { $z } { $unit }{ $free_scale ->
        [yes] , Maßstab willkürlich
        *[no] {""}
    }.

summary-few_points = { $n } von { $of } Punkten tragen { PERCENT($share) } % der Varianz bei; Median X { $x }, Y { $y }, Z { $z } { $unit }.

summary-relative_precision = Relative Genauigkeit 1 : { $n } (mittlere Standardabweichung { $std } { $std_unit }, größte Ausdehnung { $extent } { $extent_unit }).
    .why = { $class_name ->
            [none] {""}
            *[other] Klasse: { $class_name }.
        } { $omitted ->
            [0] {""}
            *[other] Ohne die { PERCENT($omitted) } % der ungenauesten Punkte.
        }

summary-noise_white = Weißes Rauschen wird angenommen: { $cause }.

summary-noise_neighbours = Die Standardabweichungen enthalten Fehler, die benachbarte Punkte teilen (Varianz mal { NUM($factor, digits: 2) }).

summary-noise_smooth = Die Standardabweichungen enthalten glatte Fehler von { NUM($sigma_px, digits: 2) } px, die von Bild zu Bild verschieden sind.

summary-noise_focus = Die Standardabweichungen enthalten einen Fokus, der um { NUM($sigma_px, digits: 2) } px schwankt.

summary-noise_factor = Standardabweichungen { $kind ->
        [interior] der inneren Orientierung
        [centres] der Projektionszentren
        *[points] der Objektpunkte
    }: { NUM($factor, digits: 2) } mal die bei weißem Rauschen (Median).

summary-relief = Relief in den Fenstern verdoppelt die Standardabweichung von { PERCENT($share) } % der Verknüpfungspunkte oder mehr.

summary-check_points = Kontrollpunkte ({ $n }): RMS der Abweichungen in { $axes }: { $rms } { $unit }.

summary-more = und { $n } weitere: mit { OPTION("verbose", "True") }.

summary-next = Nächster Schritt: { $step }

summary-files = Geschrieben: { $files }.

summary-next_surface = raybundle surface { $project } berechnet die Oberfläche.

summary-next_scale = Für einen wahren Maßstab eine Maßstabsstrecke ({ OPTION("scale_bar", "A", "B", "LÄNGE", "SIGMA") }) oder Passpunkte angeben.

summary-oriented = Orientiert: { $oriented } von { $of } { $of ->
        [one] Aufnahme
        *[other] Aufnahmen
    }, { $points } Objektpunkte{ $lost ->
        [0] {""}
        *[other] ; nicht orientiert: { LIST($names, most: 2) }
    }.
    .why = { $parts ->
            [0] {""}
            [one] Ein weiterer Teil ist nicht damit verbunden.
            *[other] { $parts } weitere Teile sind nicht damit verbunden.
        }

summary-image_points = Standardabweichung einer Bildkoordinate: { NUM($sigma_px, decimals: 3) } px (aus Verbesserungen).

summary-scenes = Satellitenszenen im Block: { $oriented } von { $of }.

summary-part = { $n } { $n ->
        [one] Aufnahme bildet
        *[other] Aufnahmen bilden
    } einen eigenen Teil: { $folder }.

summary-try_xfeat = { OPTION("features", "xfeat") } verknüpft Aufnahmen mit größeren Basen (pip install 'raybundle[learned]').

summary-marks_left_out = Nicht verwendete Punkte mit weniger als zwei Messungen ({ $n }): { $names }.

summary-text = { $text }
