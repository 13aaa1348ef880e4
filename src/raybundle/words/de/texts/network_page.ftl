network_page-title = Netz von { $name }

network_page-decimal = ,

network_page-colour_of_points = Farbe der Punkte

network_page-number_of_rays = Zahl der Strahlen

network_page-standard_deviation = Standardabweichung

network_page-role = Rolle

network_page-sigma_of_object = Standardabweichung des Objekts

network_page-colour_of_dense_points = Farbe der dichten Punkte

network_page-own_colour = eigene Farbe

network_page-source_photograph = Herkunftsaufnahme

network_page-show = Zeigen

network_page-dense_points = dichte Punkte

network_page-object_points = Objektpunkte

network_page-known_points = Pass- und Kontrollpunkte, vergrößert

network_page-images = Bilder

network_page-proposals = vorgeschlagene Aufnahmen (rot)

network_page-object = Objekt

network_page-scale_bars = Maßstabsstrecken

network_page-ellipsoids = Fehlerellipsoide (einfache Standardabweichung)

network_page-enlarged = vergrößert

network_page-first_view = erste Ansicht

network_page-mouse = Ziehen dreht, Ziehen mit der rechten Taste verschiebt, das Rad vergrößert.

network_page-click = Einen Punkt oder ein Bild anklicken, um seine Strahlen zu sehen.

network_page-no_graphics = Dieser Browser zeigt keine 3D-Grafik (WebGL ist abgeschaltet).
    .why = Der Bericht und die PLY-Datei enthalten dasselbe Netz.

network_page-tie_points = Verknüpfungspunkte

network_page-control_points = Passpunkte

network_page-check_points = Kontrollpunkte

network_page-tie_point = Verknüpfungspunkt

network_page-control_point = Passpunkt

network_page-check_point = Kontrollpunkt

network_page-rays_2 = höchstens 2 Strahlen

network_page-rays_3 = 3 Strahlen

network_page-rays_4 = 4 bis 5

network_page-rays_6 = 6 bis 9

network_page-rays_10 = 10 und mehr

network_page-image = Bild

network_page-sigma = Standardabweichung

network_page-rays = Strahlen

network_page-contents = { $points ->
        [0] Kein Objektpunkt hat Koordinaten
        *[other] { $points } { $all_points ->
            [yes] { $of_points ->
                [one] Objektpunkt
                *[other] Objektpunkte
            }
            *[no] von { $of_points } Objektpunkten
        }
    }, { $images } { $all_images ->
        [yes] { $of_images ->
            [one] Bild
            *[other] Bilder
        }
        *[no] von { $of_images } Bildern
    }.

network_page-one_per_cell = Von den Verknüpfungspunkten ist je Zelle von { NUM($cell) } { $unit ->
        [units] Einheiten
        *[other] { $unit }
    } einer gezeigt.

network_page-worst_points = Die { $n } mit den größten Standardabweichungen sind ebenfalls gezeigt.

network_page-all_in_table = Die Punkttabelle enthält alle.

network_page-images_chosen = Die Bilder sind gleichmäßig ausgewählt.

network_page-ellipsoids_of = Fehlerellipsoide (einfache Standardabweichung, 20 % Wahrscheinlichkeit) von { $n } { $n ->
        [one] Punkt
        *[other] Punkten
    }, vergrößert.

network_page-no_statistics = Standardabweichungen wurden nicht berechnet (Statistik abgeschaltet).

network_page-arbitrary_scale = Der Maßstab ist willkürlich: Längen haben keine absolute Einheit.

network_page-dense_shown = { $n ->
        [one] Ein dichter Punkt ist
        *[other] { $n } dichte Punkte sind
    } gezeigt{ $cell ->
        [0] {""}
        *[other] , einer je Zelle von { NUM($cell, digits: 2) } { $unit ->
            [units] Einheiten
            *[other] { $unit }
        }
    }.
    .why = Ihre Standardabweichungen gelten längs des Strahls.

network_page-wanted = Geforderte Standardabweichung einer Koordinate: { NUM($sigma) } { $unit ->
        [units] Einheiten
        *[other] { $unit }
    } ({ $what ->
        [worst] schlechtester Punkt
        *[mean] Mittel
    }).
    .why = Rot ist schlechter; eine Farbstufe entspricht doppelt so vielen Aufnahmen.

network_page-unseen = in weniger als zwei Bildern sichtbar
