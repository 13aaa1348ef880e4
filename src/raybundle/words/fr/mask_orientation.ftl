mask_orientation = La position de { $n } masques est ambiguë (orientation EXIF { $orientations }) : { LIST($ids, most: 3) }.
