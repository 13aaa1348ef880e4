image_list-unknown_columns = Diese Spaltennamen legen die Koordinaten nicht fest: { $names }.
    .do = imagename oder label, latitude und longitude oder X und Y, altitude, height oder Z verwenden.

image_list-unit = Die Einheit { $unit } wird nicht unterstützt.
    .do = { $quantity ->
        [height] Meter über dem Ellipsoid oder ein Höhensystem angeben (# CoordinateSystem: EPSG:4326+5773)
        [angle] Grad angeben
       *[length] Meter angeben
     }.

image_list-order_unclear = Ohne Spaltennamen ist die Reihenfolge der Koordinaten { $first } mehrdeutig.
    .do = Eine erste Zeile mit Namen ergänzen, etwa imagename,latitude,longitude,altitude.
