calibration-no_list = { $value } ist keine Liste kalibrierter Parameter.
    .do = Eine Liste von Tabellen mit parameter, value, sigma und correlations angeben.

calibration-incomplete_entry = Eintrag { $number } ist kein kalibrierter Parameter.
    .do = parameter, value, sigma und als Liste correlations mit den Einträgen davor angeben.

calibration-correlation_count = Eintrag { $number } hat { $n } Korrelationen; nötig sind { $needed }, mit den Parametern davor.
    .do = Die Liste vervollständigen.

calibration-not_positive_definite = Die Korrelationen bilden keine positiv definite Matrix.
    .do = Die Korrelationen korrigieren oder mit mehr Stellen schreiben.

calibration-format_differs = Gespeicherte Kalibrierung { $camera }: Keine Aufnahme hat ihr Format, { $width_px } x { $height_px } px.
    .do = Die Kalibrierung einer Kamera des Satzes angeben: { $known }.

calibration-several_cameras = Die gespeicherte Kalibrierung { $camera } passt zu { $n } Kameras.
    .do = Der Kalibrierung die Kennung einer dieser Kameras geben: { $known }.

calibration-two_for_camera = Zwei gespeicherte Kalibrierungen passen zur Kamera { $camera }.
    .do = Jeder die Kennung ihrer Kamera geben: { $known }.

calibration-size_differs = Kamera { $camera } hat { $width_px } x { $height_px } px, nicht { $given_width_px } x { $given_height_px } px.
    .do = Prüfen, ob es die Kalibrierung dieser Kamera ist.

calibration-pixel_size = Eine Pixelgröße von { $pixel_mm } mm ist nicht möglich.
    .do = Die Größe in mm angeben, etwa 0.0045.

calibration-one_model = Das Format { $format } hat nur ein Verzeichnungsmodell; keines ist wählbar.
    .do = Das Modell weglassen.

calibration-model_unknown = Das Format { $format } hat kein Modell { $model }.
    .do = Eines von { LIST($known, most: 20) } verwenden.

calibration-suffix = Das Format { $format } ist eine Datei mit anderer Endung.
    .do = Einen Namen mit einer der Endungen { $suffixes } angeben.

calibration-deviation = Kamera { $camera } als { $model } weicht bis zu { $deviation_px } px ab (RMS { $rms_px } px, Grenze { $limit_px } px).
    .do = Ein anderes Format oder Modell wählen oder { OPTION("approximate", "True") } angeben.

calibration-one_camera = Zu schreibende Kameras: { $n }; eine Datei des Formats { $format } hat genau eine.
    .do = Die Kameras einzeln umwandeln: { OPTION("camera", "ID") }.

calibration-second_camera = Die Datei enthält eine zweite Kamera.
    .do = Jede Kamera in einer eigenen Datei angeben.

calibration-australis_row = Parameter { $parameter } hat { $n } Zahlen; nötig sind { $needed }.
    .do = Anfangswert, Zuschlag, Endwert und die zwei Standardabweichungen angeben.

calibration-incomplete = Im Kalibrierbericht fehlen { $missing }.
    .do = Den vollständigen Bericht angeben.

calibration-impossible_values = Format { $width_px } x { $height_px } px, Pixel { $pixel_mm } mm oder c = { $c_mm } mm ist nicht möglich.
    .do = Den Wert korrigieren.

calibration-no_size = Die Datei enthält die Bildgröße nicht.
    .do = { OPTION("format", "WIDTH", "HEIGHT") } angeben.

calibration-pixels_not_square = Ein Format von { $width_mm } x { $height_mm } mm passt nicht zu { $width_px } x { $height_px } px (Pixelverhältnis { $ratio }).
    .do = Die Bildgröße korrigieren.

calibration-no_camera = Die Datei enthält keine Kamera.
    .do = Prüfen, ob es die richtige Datei ist; eine TOML-Datei hat Tabellen [cameras.ID].

calibration-size_or_distance = Format { NUM($width_px, digits: 8) } x { NUM($height_px, digits: 8) } px oder Kamerakonstante { $distance_px } px ist nicht möglich.
    .do = Den Wert korrigieren.

calibration-camera_count = Kameras in dieser Datei: { $n }; nötig ist genau eine.
    .do = Eine Kamera je Datei angeben.

calibration-no_covariance = Das ist keine Kovarianzmatrix: Eine Kovarianzmatrix ist symmetrisch und positiv definit.
    .do = Die Kalibrierung neu exportieren.

calibration-format_unclear = Die Datei könnte eines von mehreren Kalibrierformaten sein: { $names }.
    .do = Eines mit { OPTION("read_as", "FORMAT", flag: "from") } wählen: { LIST($known, most: 30) }.

calibration-format_not_recognised = Die Datei ist nicht als Kalibrierung erkennbar.
    .do = Das Format der Datei mit { OPTION("read_as", "FORMAT", flag: "from") } angeben: { LIST($known, most: 30) }.

calibration-not_estimated = Kamera { $camera }: Kein Parameter der inneren Orientierung wurde mit Statistik geschätzt.
    .do = Parameter schätzen und mit statistics=True ausgleichen.

calibration-formats_differ = Kalibrierungen von { $first_px } px und { $second_px } px lassen sich nicht vergleichen.
    .do = Eine auf das Format der anderen skalieren.

calibration-cropped_format = { $width_px } × { $height_px } px ist keine Verkleinerung von { $camera_width_px } × { $camera_height_px } px.
    .why = Das Format wurde beschnitten; der Bildhauptpunkt der Kalibrierung gilt dafür nicht.
    .do = Aufnahmen des vollen Formats verwenden oder mit Aufnahmen des beschnittenen Formats kalibrieren.

calibration-used = Kalibriert: { $used } von { $of } Aufnahmen, { $points } { $natural ->
        [yes] Objektpunkte
        *[no] Zielmarkenpunkte
    }.

calibration-grade = Kamera { $camera }: { $grade ->
        [not_determinable] nicht bestimmbar; nicht für andere Aufnahmen verwenden.
        [good] gut
        [usable] brauchbar
        *[other] schwach
    }{ $grade ->
        [not_determinable] {""}
        *[other] , Abbildung { NUM($typical_px, digits: 2) } px (Median über das Format; höchstens { NUM($largest_px, digits: 2) } px).
    }

calibration-photograph_next = { $n } weitere { $n ->
        [one] Aufnahme
        *[other] Aufnahmen
    } machen: Liste mit { OPTION("verbose", "True") }.

calibration-several = Kameras in dieser Datei: { $n }; keine ist genannt.
    .do = Eine mit { OPTION("camera") } nennen: { LIST($cameras, most: 20) }.

calibration-one_for_one = Kameras in dieser Datei: { $n }; Kameras der Aufnahmen: { $photographed }. Möglich ist je eine.
    .do = Die Kalibrierung der einen Kamera der Aufnahmen angeben.

calibration-no_camera_of_size = Kameras dieser Datei mit { $width_px } x { $height_px } px, der Größe der Aufnahme: { $n }; nötig ist eine.
    .do = Die Kalibrierung der Kamera der Aufnahme angeben.

calibration-too_few_photographs = { $n } brauchbare { $n ->
        [one] Aufnahme
       *[other] Aufnahmen
    }; eine Kalibrierung benötigt mindestens { $least }.
    .do = 10 bis 20 Aufnahmen von verschiedenen Seiten machen, einige mit um 90° verkanteter Kamera.

calibration-spline_parameters = Die Parameter des Modells spline lassen sich nicht auswählen.
    .do = { OPTION("parameters") } oder { OPTION("model") } weglassen.

calibration-too_few_points = { $n } von { $photographs } Aufnahmen zeigen { $least } gemeinsame Punkte von { $families }; nötig sind 2.
    .why = { $points } Punkte wurden gelesen, { $unnamed } ohne Code.
    .do = Die gedruckten Zielmarken nennen ({ OPTION("target") }) und so aufnehmen, dass ein Punkt oder Feld 10 px groß ist.

calibration-flat_views = Die Blickrichtungen auf das ebene Objekt weichen nur um { NUM($angle_deg, decimals: 0) }° ab; nötig sind { NUM($least_deg, decimals: 0) }°.
    .why = Aus fast einer Richtung lassen sich Kamerakonstante und Entfernung eines ebenen Objekts nicht trennen.
    .do = Konvergente Aufnahmen hinzufügen: von links, rechts, oben und unten, 30° bis 45° gegen die Normale, einige um 90° verkantet.

calibration-not_possible = Die Kamera lässt sich aus diesen Aufnahmen nicht kalibrieren.
    .do = 6 bis 20 Aufnahmen derselben Punkte machen, die um 30° bis 45° konvergieren, einige um 90° verkantet; hier genannte Aufnahmen ausschließen.

calibration-spline_worse = Kamera { $camera }: Das Modell spline passt am Ende schlechter ({ NUM($rms_px, digits: 2) } px) als zu Beginn ({ NUM($start_rms_px, digits: 2) } px).
    .why = Diese Aufnahmen bestimmen seine Flächen nicht (Kamerakonstante { $c_mm } mm).
    .do = { OPTION("model") } weglassen oder Aufnahmen hinzufügen, die das Format bis in die Ecken füllen.

calibration-inverse_in_part = Kamera { $camera }: die Verzeichnung hat nur für { PERCENT($share) } % des Formats eine Umkehrung.
    .do = Verwenden Sie keine Bildpunkte außerhalb davon.

calibration-file_unusable = { $name } ist nicht verwendbar.

calibration-none_fits = Die Kamerabibliothek hat keine Kalibrierung für { $name }.
    .do = Die Kamera kalibrieren und mit raybundle calibration add ablegen.

calibration-validity = { $reason ->
        [none] Die Verzeichnung ist über das ganze Format umkehrbar.
        [pole] Die Verzeichnung hat { NUM($angle_deg, decimals: 1) } Grad neben der Achse einen Pol
        *[fold] Die Verzeichnung faltet sich { NUM($angle_deg, decimals: 1) } Grad neben der Achse
    }{ $reason ->
        [none] {""}
        *[other] { $inside ->
            [yes] , innerhalb des Formats.
            *[no] , außerhalb des Formats.
        }
    }
    .why = { $finite ->
            [yes] Radius { NUM($radius_px, decimals: 0) } px; die Ecken liegen bei { NUM($corner_px, decimals: 0) } px.
            *[no] {""}
        }
