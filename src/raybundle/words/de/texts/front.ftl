front-title = Auf einen Blick

front-verdict = Urteil

front-client = Auftraggeber

front-operator = Bearbeiter

front-object = Objekt

front-place = Ort

front-date = Datum der Aufnahme

front-instruments = Geräte

front-rights = Rechte

front-heights = Höhen

front-coordinate_system = Koordinatensystem

front-asprs_statement = ASPRS-Aussage{ $height ->
        [yes] , Höhe
        *[no] {""}
    }

front-calibration = Kalibrierung

front-adjustment = Ausgleichung von { $name }

front-faults = Noch nicht verwenden: { $n } Fehler zu klären.

front-no_statistics = Nicht geprüft: Die Statistik ist ausgeschaltet, die Präzision ist unbekannt.

front-no_redundancy = Nicht geprüft: Es gibt keine überzähligen Beobachtungen.

front-contradicting = Noch nicht verwenden: Die Beobachtungen widersprechen sich.

front-calibration_unusable = Nicht für andere Aufnahmen verwenden: Die Kalibrierung ist { $grade ->
        [not_determinable] nicht bestimmbar
        *[weak] schwach
    }.

front-not_as_required = Nicht so genau wie gefordert.

front-usable = Verwendbar{ $n ->
        [0] {""}
        [one] , { $n } Warnung
        *[other] , { $n } Warnungen
    }.

front-not_judged = Die Forderungen sind nicht beurteilbar.

front-not_checked = Nicht unabhängig kontrolliert (keine Kontrollpunkte).

front-scale_checked = Maßstab durch { $n } Strecken geprüft (untereinander auf { $worst }); Punkte nicht geprüft (keine Kontrollpunkte).

front-severity = { $level ->
        [error] Abbruch
        [fault] Fehler
        [warning] Warnung
        [next] als Nächstes
        *[note] Hinweis
    }

front-next = Nächste Schritte

front-more_matters = { $n } weitere: siehe Warnungen.

front-handed_over = Lieferumfang

front-files = Dateien: { LIST($names, most: 15) }.

front-settled = Keine offenen Punkte.

front-not_kept_only = Die Forderungen sind nicht eingehalten (siehe oben); die Messung hat keine offenen Punkte.

front-file_name = { $name }:

front-file = { $file_name ->
        [points] Koordinaten der Objektpunkte mit Standardabweichungen.
        [map] Objektpunkte und Standpunkte im Koordinatensystem.
        [map_control] Pass- und Kontrollpunkte im Koordinatensystem.
        [coordinate_list] Koordinaten der Zielmarken mit Standardabweichungen und Korrelationen.
        [nominal] Abweichungen von den Sollkoordinaten.
        [lengths] Längenmessabweichungen.
        [images] Orientierungen der Aufnahmen.
        [calibration] kalibrierte Kameras.
        [record] Aufnahmeprotokoll.
        [check] Kontrollpunkte.
        [control] Passpunkte.
        [block] der ganze Bildverband, für eine neue Ausgleichung.
        [displacements] Verschiebungen mit Standardabweichungen und Urteil.
        [velocities] Geschwindigkeiten und Beschleunigungen.
        [surface_strain] Dehnungen der Oberfläche.
        [epochs] Daten der Aufnahmen, bewegte Punkte und Flächen, für Programme.
        *[network] Netz in drei Dimensionen.
    }

front-dense_points = Punktwolke eines früheren Ergebnisses: { $file_name }.

front-system_of_control = Das der Passpunkte (kein Name angegeben).

front-heights_relative = Relativ: Keine Höhe wurde angegeben.

front-heights_of_geoid_value = { $name }, Geoidundulation { NUM($undulation_m, digits: 6) } m.

front-heights_of_grid = { $name }, Geoidmodell { $grid }.

front-heights_above_geoid = Über dem Geoid, Undulation { NUM($undulation_m, digits: 6) } m.

front-heights_ellipsoidal = Über dem Ellipsoid.

front-heights_assumed = Im Koordinatensystem nicht definiert; ellipsoidische Höhen angenommen.

front-of_given = von { $n } gegebenen

front-rays = jeder in { NUM($n) } Aufnahmen (Median)

front-uncertainty = Median über das Format im Unendlichen; größte { NUM($largest_px, digits: 2) } px.

front-worst_camera = Kamera { $camera }, die schlechteste von { $n }.

front-good_to = geeignet für Messungen bis

front-largest_error = größter Fehler über das Format (Wahrscheinlichkeit 95 %)

front-coverage = von Bildpunkten aller Aufnahmen bedeckt

front-median_uncertainty = Unsicherheit, Median

front-largest_uncertainty = größte

front-uncertainty_meaning = Unsicherheit eines Bildpunkts allein durch die Kalibrierung, über das Format, im Unendlichen.

front-gsd = Bodenauflösung (GSD)

front-gsd_range = Median über die Objektpunkte; 98 % zwischen { NUM($low) } und { NUM($high) } { $unit }

front-flying_height = Flughöhe

front-above_ground = über Grund, Median über die Aufnahmen

front-area = Fläche

front-area_of_one = in mindestens drei Aufnahmen, innerhalb der Objektpunkte; in mindestens einer: { NUM($area) } { $unit }

front-std_of_coordinate = Einer Koordinate, { $median ->
        [yes] Median
        *[no] RMS
    } über die Objektpunkte:

front-quotient = Mittlere Standardabweichung { NUM($mean) } { $unit }, Ausdehnung { NUM($extent) } { $length_unit }{ $share ->
        [0] {""}
        *[other] , ohne die { PERCENT($share) } % ungenauesten Punkte
    }.

front-check_rms = Differenz einer Koordinate an { $n } { $n ->
        [one] Kontrollpunkt
        *[other] Kontrollpunkten
    } (RMS):

front-leave_one_out = Kreuzvalidierung der Passpunkte

front-leave_one_out_rms = Differenz einer Koordinate an { $n } { $n ->
        [one] Passpunkt
        *[other] Passpunkten
    }, jeder weggelassen (RMS):

front-minus_given = d: ausgeglichen minus gegeben. Passpunkte nahmen teil, Kontrollpunkte nicht.

front-largest_differences = Die { $most } größten Differenzen von { $n } { $role ->
        [control] Passpunkten
        *[check] Kontrollpunkten
    }; alle: { $file_name }.

front-leave_one_out_row = Kreuzvalidierung der Passpunkte, RMS

front-leave_one_out_meaning = Kreuzvalidierung: Differenz ohne den Passpunkt, in erster Näherung.

front-dash = –: { $cause ->
        [lost] nicht gegeben
        [open] nicht verglichen, im Datum offen
        *[both] nicht gegeben oder im Datum offen
    }.

front-role = { $role ->
        [control] Passpunkt
        *[check] Kontrolle
    }

front-rms_of = RMS von { $n }

front-held = fest

front-rms = RMS

front-median = Median

front-quantile_95 = 95 % unter

front-largest = größte

front-standard_deviations = Standardabweichungen der Objektpunkte. { $lengths ->
        [yes] Unabhängige Längen: siehe oben.
        *[no] Keine Pass- und Kontrollpunkte: nicht unabhängig kontrolliert.
    }

front-weakest_point = Größte: Punkt { $point }, in { $n } { $n ->
        [one] Aufnahme
        *[other] Aufnahmen
    }.

front-known_lengths = Diese Längen nahmen teil. Kreuzvalidierung: Länge aus den übrigen minus gegebene, in erster Näherung.

front-more_lengths = { $n } weitere: distances.csv.
