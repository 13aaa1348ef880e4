query-image_without_part = Das Bild { $image } ging nicht in die Ausgleichung ein.
    .do = Es weglassen.

query-unknown_own = { $name } ist keine Unbekannte einer Beobachtungsart dieser Ausgleichung.
    .do = KIND:NAME angeben, z. B. plane:floor.

query-unknown = { $name } ist keine Unbekannte dieser Ausgleichung.
    .do = point:ID, image:ID, camera:ID oder KIND:NAME (z. B. plane:floor) eines geschätzten Objekts angeben.
