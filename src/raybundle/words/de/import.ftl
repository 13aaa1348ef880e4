import-camera_fitted = Kamera { $camera } ist als Modell { $model } gelesen, über das Format angepasst: größte Abweichung { $deviation_px } px.
    .why = { $whole ->
     [yes] { "" }
     *[no] Die Verzeichnung der Kamera lässt sich über { PERCENT($covered) } % des Formats umkehren.
    }

import-not_read = { $n } { $n ->
     [one] Element der Datei wurde
     *[other] Elemente der Datei wurden
    } nicht gelesen: { LIST($kinds, most: 6) }.

import-repeated_observations = { $n } { $n ->
     [one] Beobachtung wiederholt einen Punkt im selben Bild und ist
     *[other] Beobachtungen wiederholen einen Punkt im selben Bild und sind
    } weggelassen.

import-sigma_assumed = Standardabweichung der Bildbeobachtungen: nicht im Format enthalten; { $sigma_px } px angenommen.

import-sensors_without_pose = { $n } { $n ->
     [one] Bild hat einen Sensor
     *[other] Bilder haben Sensoren
    } ohne Orientierung im Kameraverbund; die Orientierungen der Bilder werden verwendet.

import-rig_poses_differ = Die Orientierungen von { $n } von { $total } Bildern unterscheiden sich zwischen Bildern und Kameraverbünden; die der Kameraverbünde werden verwendet.
    .why = Die größten Unterschiede sind { $apart } in der Position (Bild { $image }) und { $angle_deg }°.

import-points_without_object = { $n } von { $total } Bildpunkten gehören zu keinem Objektpunkt und sind weggelassen.

import-format_assumed = { $format } enthält weder Format noch Pixelgröße; ein Format um die Bildpunkte und { $pixel_mm } mm angenommen.
    .do = { $table } in den Ordner legen, wenn sie bekannt sind.

import-control_sigma_assumed = { $n } { $n ->
     [one] Passpunkt hat
     *[other] Passpunkte haben
    } keine Standardabweichung; { $plan_m } m in der Lage und { $height_m } m in der Höhe angenommen.

import-orientation_convention = Die Orientierungen sind als { $reading ->
     [pok_gon] phi, omega, kappa in gon
     [opk_gon] omega, phi, kappa in gon
     [opk_deg] omega, phi, kappa in Grad
     [object_to_image] Drehungen von Objekt- zu Bildachsen
     *[image_to_object] Drehungen von Bild- zu Objektachsen
    } gelesen.
    .why = Die Bildpunkte passen besser zu dieser Konvention als zu der des Formats.

import-not_oriented = { $n } von { $total } Aufnahmen haben keine äußere Orientierung.

import-focal_length_contradicts = { $name } ({ NUM($used_px, digits: 6) } px) und { $other } ({ NUM($other_px, digits: 6) } px) widersprechen einander; { $name } wird verwendet.

import-no_observations = Das Format enthält keine Bildbeobachtungen.

import-first_reconstruction = Die Datei hat { $n } Rekonstruktionen; die erste wird gelesen.
    .why = Jede davon liegt in einem eigenen Koordinatensystem.

import-no_tracks = Es gibt keine Bildpunktfolgen ({ $name }); Bildbeobachtungen werden nicht gelesen.

import-system_of_file = Die Koordinaten sind in { $system }.
    .do = { OPTION("crs") } mit diesem System angeben.

import-processing_frame = Die Koordinaten sind im Verarbeitungssystem des Projekts, verschoben um { LIST($shift, most: 3) }.
    .why = Bezug ist { $system }{ $scaled ->
     [yes] ; Maßstabsfaktor { LIST($scale, most: 3) }
     *[no] { "" }
    }{ $swapped ->
     [yes] ; X und Y sind vertauscht
     *[no] { "" }
    }.

import-elements_left_out = { $n } { $kind ->
     [sensor] { $n ->
     [one] Sensor
     *[other] Sensoren
     }
     [transform] { $n ->
     [one] Transformation
     *[other] Transformationen
     }
     [rotation_or_location_of_a_sensor] { $n ->
     [one] Einbau eines Sensors
     *[other] Einbauten von Sensoren
     }
     [marker] { $n ->
     [one] Marker
     *[other] Marker
     }
     [reference_of_a_marker] { $n ->
     [one] Referenz eines Markers
     *[other] Referenzen von Markern
     }
     *[camera] { $n ->
     [one] Kamera
     *[other] Kameras
     }
    } der Datei weggelassen; Grund beim ersten Element:

import-elements_disabled = { $n } deaktivierte { $kind ->
     [disabled_marker] Marker
     *[disabled_camera] { $n ->
     [one] Kamera
     *[other] Kameras
     }
    } { $n ->
     [one] wird
     *[other] werden
    } nicht verwendet.

import-one_chunk = Die Datei hat { $n } Chunks; Chunk { $number } wird gelesen.
    .why = Der erste aktive Chunk mit Kameras hat Vorrang.

import-chunk_disabled = Der Chunk ist deaktiviert; kein anderer hat Kameras.

import-sensor_without_calibration = Sensor { $sensor } hat keine Kalibrierung und ist mit seinen Bildern weggelassen.

import-no_object_space = Der Chunk hat keine Transformation in den Objektraum; seine Koordinaten haben keinen Maßstab.

import-components_apart = { $n } { $n ->
     [one] Bild ist ohne Orientierung gelesen: Die Komponente dieses Bildes hat
     *[other] Bilder sind ohne Orientierung gelesen: Die Komponenten dieser Bilder haben
    } keine Transformation zu den übrigen.

import-geocentric = Der Chunk ist georeferenziert: Seine Koordinaten sind geozentrisch (X, Y, Z der Erde).

import-marker_sigma_assumed = { $n } { $n ->
     [one] Marker hat
     *[other] Marker haben
    } keine Genauigkeit; die Standardabweichung des Chunks von { LIST($sigma_m, most: 3) } angenommen.

import-system_not_read = Das Koordinatensystem des Chunks lässt sich nicht lesen:

import-markers_converted = Die Koordinaten der Marker sind von { $unit } in Meter umgerechnet (1 { $unit } = { $length_m } m).
