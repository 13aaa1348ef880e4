mission_picture-take_off = Startplatz

mission_picture-battery = Akku { $number }

mission_picture-photographs_of_place = Aufnahmen, die eine Stelle zeigen

mission_picture-gap = Lücke { $number }

mission_picture-gaps = { $name }: erneut zu fliegen
