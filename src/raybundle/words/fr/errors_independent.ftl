errors_independent = Avec { $images } photographies, les erreurs des points image sont supposées indépendantes (sinon il en faut { $least }).
