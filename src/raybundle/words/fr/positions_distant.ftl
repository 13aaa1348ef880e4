positions_distant = Les positions de { $table } sont à { $distance_km } km de celles enregistrées dans les { $photographs } photographies.
