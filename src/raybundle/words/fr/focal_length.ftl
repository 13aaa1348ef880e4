focal_length-not_positive = La distance focale est { $lengths } ; elle doit être positive.
