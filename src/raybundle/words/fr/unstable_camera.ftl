unstable_camera = Caméra { $camera } : son orientation interne a changé entre les photographies ({ $n } et { $others }).
