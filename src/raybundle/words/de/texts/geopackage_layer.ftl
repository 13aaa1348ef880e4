geopackage_layer-displacements = Verschiebungen seit dem früheren Datum, am damaligen Ort des Punktes; sd..: Standardabweichungen; Meter
