report_compare-title = { $first } und { $second }

report_compare-subtitle = Vergleich zweier Ausgleichungen. Erste: { $first }; zweite: { $second }.

report_compare-summary = Nebeneinander

report_compare-interior = Innere Orientierung

report_compare-points = Objektpunkte

report_compare-images = Bilder

report_compare-warnings = Warnungen

report_compare-sigma0 = σ₀ { NUM($first) } und { NUM($second) }.

report_compare-interior_ratio = Innere Orientierungen unterscheiden sich um bis zu { NUM($ratio, digits: 2) } { $part ->
        [yes] Standardabweichungen einer Differenz
        *[no] kombinierte Standardabweichungen
    }.

report_compare-points_differ = { $n } gemeinsame { $n ->
        [one] Punkt unterscheidet
        *[other] Punkte unterscheiden
    } sich um { NUM($rms, digits: 2) } { $unit ->
        [units] Einheiten
        *[other] { $unit }
    } RMS { $fitted ->
        [yes] nach einer Ähnlichkeitstransformation
        *[no] ohne Transformation
    }.

report_compare-small_redundancy = Die Redundanz der Transformation ist nur { $n }.

report_compare-no_same_point = Kein Objektpunkt ist sicher derselbe in beiden.

report_compare-quantity = { $name ->
        [sigma0] σ₀ a posteriori
        [redundancy] Redundanz
        [observations] Beobachtungen
        [unknowns] Unbekannte
        [constraints] Datumsbedingungen
        [image_points] gegebene Bildbeobachtungen
        [rejected] verworfene Bildbeobachtungen
        [images_count] gegebene Bilder
        [points_count] gegebene Objektpunkte
        [relative_precision] relative Genauigkeit 1 : N
        [iterations] Iterationen
        [seconds] Sekunden
        [datum] Datum
        *[raybundle] raybundle
    }

report_compare-setting = Einstellung { $name }

report_compare-first = erste

report_compare-second = zweite

report_compare-both = beide

report_compare-difference = zweite − erste

report_compare-cameras_of_one = Nur in einer der beiden: { LIST($names, most: 12) }.

report_compare-no_common_camera = Die beiden Ergebnisse haben keine gemeinsame Kamera.

report_compare-in_sigmas = in { $part ->
        [yes] ihren Standardabweichungen
        *[no] kombinierten Standardabweichungen
    }

report_compare-correlated = Parameter einer Kamera sind korreliert: Differenzen von einigen Standardabweichungen können sich im Bild aufheben.

report_compare-common_points = { $n } gemeinsame { $n ->
        [one] Punkt
        *[other] Punkte
    }.

report_compare-common_images = { $n } gemeinsame { $n ->
        [one] Bild
        *[other] Bilder
    }.

report_compare-only_in = Nur in { $which ->
        [first] der ersten
        *[second] der zweiten
    }: { LIST($names, most: 20) }.

report_compare-namesakes = { $n } { $n ->
        [one] Punkt
        *[other] Punkte
    } mit demselben automatischen Namen { $n ->
        [one] ist verschieden und wird
        *[other] sind verschieden und werden
    } nicht verglichen: { LIST($names, most: 3) }.
    .why = Automatische Namen sind laufende Nummern; die Bildpunkte liegen an anderen Stellen.

report_compare-free_datum = Ergebnisse mit eigenem Datum (freie Netze) nur nach der Transformation vergleichen.

report_compare-too_few_points = Es gibt zu wenige gemeinsame Punkte für eine Ähnlichkeitstransformation.

report_compare-transformed = { $fitted ->
        [yes] Nach einer Ähnlichkeitstransformation der zweiten auf die erste
        *[no] Ohne Transformation
    }

report_compare-transformation = Maßstab 1 { $larger ->
        [yes] +
        *[no] −
    } { NUM($scale) }, Drehung { NUM($rotation_deg) }°, Verschiebung ({ $translation }) { $unit ->
        [units] Einheiten
        *[other] { $unit }
    }.

report_compare-rms_ratio = RMS von d / σ

report_compare-largest_differences = Die größten Differenzen

report_compare-sigma_of = { $part ->
        [yes] σ
        *[no] kombiniertes σ
    } { $axis }

report_compare-centres = Projektionszentren unterscheiden sich um { NUM($rms) } { $unit ->
        [units] Einheiten
        *[other] { $unit }
    } RMS, Drehungen um { NUM($rotation_deg) }°.
    .why = { $by ->
            [points] Im System der ersten, nach der Ähnlichkeitstransformation der Punkte.
            [centres] Im System der ersten, nach der Ähnlichkeitstransformation der Projektionszentren.
            *[none] Ohne Transformation.
        }

report_compare-own_transformation = Nach einer eigenen Transformation unterscheiden sich die Projektionszentren um { NUM($rms) } { $unit ->
        [units] Einheiten
        *[other] { $unit }
    } RMS.

report_compare-projection_centre = Projektionszentrum

report_compare-rotation = Drehung

report_compare-all_images = Alle Bilder, die größte Differenz zuerst

report_compare-no_warning = Keines der Ergebnisse hat eine Warnung.

report_compare-severity = Schwere

report_compare-code = Code

report_compare-message = Meldung

report_compare-sigma_meaning = { $part ->
        [yes] Standardabweichung: Wurzel der Differenz beider Varianzen.
        *[no] Kombiniert: Wurzel der Summe beider Varianzen, wie bei unabhängigen Ergebnissen.
    }

report_compare-same = Die beiden Ergebnisse sind bis auf das letzte Bit gleich.

report_compare-part_of_other = Die Ergebnisse teilen { $n } von { $used_first } und { $used_second } Bildbeobachtungen.
    .why = Die Beobachtungen { $part ->
            [first] der ersten
            *[second] der zweiten
        } sind Teil der anderen; verglichen wird mit der Wurzel der Differenz beider Varianzen.

report_compare-not_independent = Die Ergebnisse teilen { $n } von { $used_first } und { $used_second } Bildbeobachtungen und sind nicht unabhängig.
    .why = Kombinierte Standardabweichungen sind zu groß; wirkliche Differenzen können unauffällig sein.

report_compare-noise_models = Das Rauschmodell ist { $same ->
        [yes] { $first } in beiden
        *[no] { $first } in der ersten und { $second } in der zweiten
    }.

report_compare-noise_ratios = Daher sind Standardabweichungen von Punkten das { NUM($first) }- und { NUM($second) }-fache derer bei weißem Rauschen.

report_compare-basis = Die Transformation beruht auf { $n } gemeinsamen { $centres ->
        [yes] Projektionszentren
        *[no] Punkten
    }: { $coordinates } Koordinaten, Redundanz { $redundancy }.

report_compare-small_basis = Vorsicht: Der RMS der Differenzen ist um { NUM($uncertainty_percent, digits: 2) } % unsicher.
    .why = Die Transformation nimmt im Mittel { NUM($absorbed_percent, digits: 2) } % ihrer Quadratsumme auf.

report_compare-no_common_observation = Keine Bildbeobachtung ist beiden gemeinsam.

report_compare-rejected_otherwise = Von { $n } gemeinsamen Bildbeobachtungen sind { $first } nur in der ersten verworfen, { $second } nur in der zweiten.

report_compare-rejected_alike = Dieselben von { $n } gemeinsamen Bildbeobachtungen nehmen in beiden teil.

report_compare-free_in = Frei nur in { $which ->
        [first] der ersten
        *[second] der zweiten
    }: { LIST($names, most: 12) }.

report_compare-free_alike = Dieselben Parameter der Kameras sind frei.
