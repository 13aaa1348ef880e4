verdict-points_rms = { $n } { $n ->
        [one] Objektpunkt
        *[other] Objektpunkte
    }, Standardabweichung { NUM($sigma, digits: 2) } { $unit } (RMS je Koordinate).

verdict-points_median = { $n } Objektpunkte, Standardabweichung einer Koordinate { NUM($sigma, digits: 2) } { $unit } (Median; RMS { NUM($rms, digits: 2) }).

verdict-few_points = { $n } von { $of } Punkten { $n ->
        [one] trägt
        *[other] tragen
    } { PERCENT($share) } % der Varianz bei.

verdict-points_plan = { $n } { $n ->
        [one] Objektpunkt
        *[other] Objektpunkte
    }, Standardabweichung in X und Y { NUM($sigma, digits: 2) } { $unit } (RMS); Höhen sind relativ.

verdict-points_relative = { $n } { $n ->
        [one] Objektpunkt
        *[other] Objektpunkte
    }, relative Präzision 1 : { $relative }; kein absoluter Maßstab.

verdict-relative = Relative Präzision 1 : { $relative } (Mittel).

verdict-at_check_points = Kontrollpunkte: { NUM($rms, digits: 2) } { $unit } (RMS).

verdict-at_lengths = { $n } unabhängige { $n ->
        [one] Länge
        *[other] Längen
    }: { NUM($rms_mm, digits: 2) } mm (RMS).

verdict-no_statistics = Koordinaten ohne Standardabweichungen: Die Statistik ist ausgeschaltet.

verdict-all_held = Alle Objektpunkte und Bilder sind festgehalten.

verdict-points_held = Alle Objektpunkte sind festgehalten.

verdict-centres = Standardabweichung (Mittel): Projektionszentren { NUM($centre) } { $unit }, Winkel { NUM($angle_deg) }°.

verdict-no_redundancy = Keine Redundanz: Das Ergebnis ist nicht kontrolliert.

verdict-contradicting = Die Beobachtungen widersprechen sich: σ₀ = { NUM($sigma0, digits: 2) } (a priori 1). Zuerst die Ursache klären.

verdict-faults = { $n } Fehler: vor der Verwendung klären (siehe Warnungen).

verdict-systematic = Die Verbesserungen haben einen systematischen Anteil, den diese Zahlen nicht enthalten (siehe Warnungen).

verdict-scale_unchecked = Keine zweite Länge bestätigt den Maßstab.

verdict-fits_worse = Die Verbesserungen sind { NUM($sigma0, digits: 2) }-mal so groß wie a priori angenommen; die Standardabweichungen berücksichtigen das.

verdict-fits_better = Die Verbesserungen sind kleiner als angenommen (σ₀ = { NUM($sigma0, digits: 2) }).

verdict-fits = Die Verbesserungen entsprechen der Präzision a priori.

verdict-adjusted = { $images } { $images ->
        [one] Bild
        *[other] Bilder
    } von { $cameras } { $cameras ->
        [one] Kamera
        *[other] Kameras
    }, { $points } { $points ->
        [one] Objektpunkt
        *[other] Objektpunkte
    }, { $observations } Bildbeobachtungen.

verdict-observed = { $kind ->
        [control] Passpunkte
        [check] Kontrollpunkte
        [distance] Maßstabsstrecken
        [station] Beobachtete Projektionszentren
        [attitude] Beobachtete Drehungen
        [coordinate] Punkte anderer Netze
        [deviation] Abweichungen einzelner Bilder
        [direction] Richtungen
        [zenith_angle] Zenitwinkel
        [slope_distance] Schrägstrecken
        [difference] Koordinatenunterschiede
        [plane] Ebenen
        [line] Geraden
        [plumb_line] Lotlinien
        [level] Waagrechten
        *[other] Beobachtungen der Art { $kind }
    }: { $n }.

verdict-redundancy = Unbekannte: { $unknowns }. Redundanz: { $redundancy }.

verdict-datum_fixed = Die Beobachtungen legen Lage, Orientierung und Maßstab fest.

verdict-datum_open = Durch Beobachtungen nicht festgelegt: { $which ->
        [position_orientation_scale] Lage, Orientierung und Maßstab
        [position_orientation] Lage und Orientierung
        [position_scale] Lage und Maßstab
        [orientation_scale] Orientierung und Maßstab
        [position] Lage
        [orientation] Orientierung
        [scale] Maßstab
        [line] Drehung um eine Gerade
        *[other] { LIST($parts, most: 7) } (t Lage, r Drehung, m Maßstab)
    }.

verdict-lengths_without_unit = Längen haben keine absolute Einheit.

verdict-datum_by = Datum:

verdict-each_axis = { $axes ->
        [xyz] { $a } { NUM($x) }; { $b } { NUM($y) }; { $c } { NUM($z) }
        [xy] { $a } { NUM($x) }; { $b } { NUM($y) }
        [z] { $c } { NUM($z) }
        *[other] RMS { NUM($all) }
    } { $unit }.

verdict-not_computed = Standardabweichungen wurden nicht berechnet. Mit Statistik erneut ausgleichen.

verdict-std_rms = Standardabweichung der Objektpunkte (RMS):

verdict-std_largest = Größte: { NUM($largest) } { $unit } ({ $axis } von Punkt { $point }).

verdict-std_median = Median:

verdict-relative_precision = Relative Präzision 1 : { $relative }: Mittel { NUM($mean) } { $unit }, Ausdehnung { NUM($extent) } { $length_unit }{ $share ->
        [0] {""}
        *[other] , ohne die { PERCENT($share) } % ungenauesten Punkte
    }.

verdict-precision_class = Klasse: { $name ->
        [photogrammetric] photogrammetrisch (1:200 000 oder besser)
        [professional] professionell (1:100 000)
        [amateur] Amateur (1:25 000)
        *[below] unter Amateur (1:25 000)
    }.

verdict-not_compared = Kontrollpunkte sind nicht verglichen: Das Datum legt keine ihrer Koordinaten fest.

verdict-tested_by_lengths = Keine Kontrollpunkte; unabhängige Längen prüfen die Genauigkeit.

verdict-not_tested = Die Genauigkeit ist nicht unabhängig kontrolliert (keine Kontrollpunkte).

verdict-check_points = { $n } { $n ->
        [one] Kontrollpunkt
        *[other] Kontrollpunkte
    }, ausgeglichen minus gegeben (RMS):

verdict-check_ratio = Das ist das { NUM($ratio, digits: 2) }-Fache des erwarteten Werts: { $meaning ->
        [larger] signifikant mehr (siehe Warnungen)
        [smaller] signifikant weniger ({ $n } Werte), oder gemeinsame Fehler
        *[chance] nicht signifikant ({ $n } Werte)
    }.

verdict-check_shift = Die Differenzen enthalten die Verschiebung zwischen dem Datum und den Kontrollpunkten.

verdict-no_fit = Keine Redundanz: Die Anpassung ist nicht prüfbar, grobe Fehler sind nicht auffindbar.

verdict-sigma0 = σ₀ = { NUM($sigma0) } (a priori 1).

verdict-fit_groups = Jede Beobachtungsgruppe hat einen geschätzten Varianzfaktor oder ihre Präzision a priori.

verdict-fit_from_residuals = Kein unabhängiger Test: Die Standardabweichungen a priori wurden aus diesen Verbesserungen geschätzt.

verdict-fit_passed = Globaltest (5 %) bestanden: Die Verbesserungen entsprechen der Präzision a priori.

verdict-fit_smaller_estimated = Die Verbesserungen sind kleiner als bei der Gewichtsbestimmung: kein Test. Die Standardabweichungen berücksichtigen das.

verdict-fit_smaller = Globaltest (5 %): Die Verbesserungen sind kleiner als angenommen. Die Standardabweichungen berücksichtigen das.

verdict-fit_nearly = Globaltest (5 %): Die Verbesserungen sind um weniger als { $percent } % größer als angenommen. Berücksichtigt{ $harmless ->
        [yes] ; ohne praktische Wirkung.
        *[no] .
    }

verdict-fit_larger = Globaltest (5 %) nicht bestanden: Die Verbesserungen sind größer als angenommen. Die Standardabweichungen berücksichtigen das.
    .why = Die Beobachtungen sind ungenauer als angenommen, das Modell ist unvollständig, oder grobe Fehler sind geblieben.

verdict-control_held = { $kind ->
        [distance] Maßstabsstrecken
        [station] Projektionszentren
        *[control] Passpunktkoordinaten
    }: { $n } festgehalten, nicht durch Verbesserungen geprüft.

verdict-control_unchecked = { $kind ->
        [distance] Maßstabsstrecken
        [station] Projektionszentren
        *[control] Passpunktkoordinaten
    }: { $n } beobachtet, alle für das Datum nötig, keine kontrolliert.

verdict-control_residual = { $kind ->
        [distance] Maßstabsstrecken
        [station] Projektionszentren
        *[control] Passpunktkoordinaten
    }: Verbesserungen { NUM($rms) } (RMS), größte { NUM($largest) } { $unit } ({ $n } beobachtet{ $held ->
        [0] {""}
        *[other] , { $held } festgehalten
    }).

verdict-rejected = { $n } { $n ->
        [one] Bildbeobachtung
        *[other] Bildbeobachtungen
    } verworfen, mit Gründen aufgelistet.

verdict-none_rejected = Keine Beobachtung wurde verworfen.

verdict-blunders_not_tested = Auf grobe Fehler wurde nicht geprüft.

verdict-beyond = { $n } verwendete { $n ->
        [one] Bildbeobachtung überschreitet
        *[other] Bildbeobachtungen überschreiten
    } den kritischen Wert von { NUM($critical) } Standardabweichungen.
    .do = { $snooping ->
            [yes] {""}
            *[no] Data-Snooping verwenden ({ OPTION("reject", "snooping") }).
        }

verdict-none_beyond = Keine Verbesserung überschreitet den kritischen Wert von { NUM($critical) } Standardabweichungen.

verdict-interior_held = Die innere Orientierung ist festgehalten; die Standardabweichungen enthalten ihre Fehler nicht.

verdict-interior_estimated = { $n } Parameter der inneren Orientierung geschätzt.

verdict-not_determinable = Nicht bestimmbar: { LIST($names, most: 8) }.

verdict-not_significant = Nicht signifikant, auf null gesetzt: { LIST($names, most: 8) }.

verdict-interior_better = Alle sind genauer bekannt als a priori.

verdict-least_certain = Am unsichersten: { $symbol }{ $cameras ->
        [one] {""}
        *[other] {" "}der Kamera { $camera }
    }, Standardabweichung im Bild { NUM($px, digits: 2) } px.
