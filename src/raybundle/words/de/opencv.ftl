opencv-matrix_size = Die Matrix kündigt { $rows } x { $columns } Elemente an, hat aber { $n }.
    .do = Prüfen, ob die Datei vollständig ist.

opencv-size_expected = Hier werden Breite und Höhe des Bildes erwartet.
    .do = Zwei ganze Zahlen angeben.

opencv-no_matrix = Die Datei hat keine Kameramatrix.
    .do = Die Kameramatrix wie eines von { LIST($names, most: 12) } benennen.

opencv-fisheye = Das ist die Kalibrierung eines Fischauges.
    .do = { OPTION("read_as", "opencv-fisheye", flag: "from") } angeben.

opencv-matrix_form = Die Kameramatrix hat nicht die Form [fx s cx; 0 fy cy; 0 0 1] mit positiven fx, fy.
    .do = Die Kameramatrix korrigieren.

opencv-coefficient_count = Verzeichnungskoeffizienten: { $n }; OpenCV hat { LIST($known, most: 8) }.
    .do = Prüfen, ob die Datei vollständig ist, oder das Fischaugenmodell angeben.

opencv-size_interchanged = Der Bildhauptpunkt { $x_px }, { $y_px } px liegt nahe der Mitte von { $height_px } x { $width_px } px.
    .why = Das angegebene Format ist { $width_px } x { $height_px } px.
    .do = Breite und Höhe vertauschen.

opencv-principal_point_outside = Der Bildhauptpunkt { $x_px }, { $y_px } px liegt außerhalb des Formats { $width_px } x { $height_px } px.
    .do = Die Bildgröße angeben, zu der die Matrix gehört.
