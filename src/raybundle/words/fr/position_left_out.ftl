position_left_out = La position de { $image } contredit les autres de { $distance } m et n'est pas utilisée.
