flight_check-sharpness = sharpness of photographs
