"""The files to start from on the page of clusters: read as what they are for, and their commands understood."""

import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

import click
import pytest

from raybundle.cli.main import cli
from raybundle.pipeline.executors import Threads
from raybundle.pipeline.project import Project
from raybundle.pipeline.stage import Means
from tests.pipeline.graph import digest, done_by, tasks_of

ROOT = Path(__file__).resolve().parents[2]
FILES = ROOT / "docs/how-to/cluster-files"
SHELL = [(FILES / name).read_text() for name in ("shards.sh", "orient.sh")]
YAML = [(FILES / name).read_text() for name in ("compose.yaml", "kubernetes.yaml")]


def understood(words):
    """Parse a command line of raybundle; raises for an option that there is not."""
    command = cli.get_command(click.Context(cli), words[0])
    _, rest, _ = command.make_parser(click.Context(command)).parse_args(list(words[1:]))
    assert not [w for w in rest if w.startswith("--")], words


def loaded(text):
    yaml = pytest.importorskip("yaml")
    return list(yaml.safe_load_all(text))


def test_the_containers_of_compose_are_commands_of_ours():
    (services,) = (document["services"] for document in loaded(YAML[0]))
    assert {name: shlex.split(s["command"])[0] for name, s in services.items()} == {
        "scheduler": "scheduler", "worker": "worker",
    }  # fmt: skip
    for service in services.values():
        understood(shlex.split(service["command"]))
        assert service["volumes"] == ["./data:/data"]
    arguments = services["scheduler"]["build"]["args"]
    dockerfile = (ROOT / "Dockerfile").read_text()
    assert all(f"ARG {name}" in dockerfile for name in arguments)


def test_the_manifests_of_kubernetes_are_commands_of_ours():
    documents = loaded(YAML[1])
    assert [d["kind"] for d in documents] == ["Deployment", "Deployment", "Job"]
    claims = set()
    for document in documents:
        pod = document["spec"]["template"]["spec"]
        (container,) = pod["containers"]
        understood(container["args"])
        claims |= {v["persistentVolumeClaim"]["claimName"] for v in pod["volumes"]}
        if document["kind"] == "Deployment":
            labels = document["spec"]["template"]["metadata"]["labels"]
            assert document["spec"]["selector"]["matchLabels"] == labels
    assert claims == {"raybundle-data"}


STAND_IN = """
import sys
from pathlib import Path
from raybundle.errors import TasksWaiting
from raybundle.pipeline.project import Project
from raybundle.pipeline.shards import Shards
from raybundle.pipeline.stage import Means
from raybundle.cli.main import main
from tests.pipeline.graph import tasks_of
if __name__ == "__main__":
    if sys.argv[1] != "orient":
        sys.exit(main(sys.argv[1:]))
    project = Project.open(Path(sys.argv[sys.argv.index("--out") + 1]))
    try:
        Means(project=project, executor=Shards()).do(tasks_of(8), "graph")
    except TasksWaiting as waiting:
        sys.exit(waiting.exit_status)
    finally:
        project.close()
"""
"""`raybundle` whose `orient` has the tasks of a small graph, and no others"""
SBATCH = """#!/bin/bash
shift
for k in 3 0 2 1; do
  SLURM_ARRAY_TASK_ID=$k SLURM_ARRAY_TASK_COUNT=4 SLURM_CPUS_PER_TASK=1 bash "$@" || true
done
"""
"""A queue that does the jobs of an array one after the other, in an order of its own"""


@pytest.mark.long
@pytest.mark.skipif(os.name == "nt", reason="there is no bash here")
def test_the_files_for_slurm_work_with_a_queue(tmp_path):
    (tmp_path / "stand_in.py").write_text(STAND_IN)
    jobs = {"shards.sh": SHELL[0], "orient.sh": SHELL[1]}
    assert "#SBATCH --array=0-31" in jobs["shards.sh"]
    jobs["shards.sh"] = jobs["shards.sh"].replace('"$SLURM_CPUS_PER_TASK"', '"$SLURM_CPUS_PER_TASK" --wait 0')
    programs = {"raybundle": f'#!/bin/bash\nexec {sys.executable} {tmp_path}/stand_in.py "$@"\n', "sbatch": SBATCH}
    (tmp_path / "bin").mkdir()
    for name, text in {**jobs, **{f"bin/{n}": t for n, t in programs.items()}}.items():
        (tmp_path / name).write_text(text)
        (tmp_path / name).chmod(0o755)
    done = subprocess.run(
        ["bash", "orient.sh"], cwd=tmp_path, capture_output=True, text=True, check=False,
        env={**os.environ, "PYTHONPATH": str(ROOT), "PATH": f"{tmp_path / 'bin'}{os.pathsep}{os.environ['PATH']}"},
    )  # fmt: skip
    assert done.returncode == 0, done.stdout + done.stderr
    tasks = tasks_of(8)
    project = Project.open(tmp_path / "project")
    try:
        means = Means(project=project, executor=Threads(1))
        assert means.do(tasks, "graph") == {}
        assert means.made == 0
        found = digest(project.products, tasks, {t.key: means.small(t.key) for t in tasks if t.small})
        assert found == done_by(Threads(1), tasks, type(project.products)(tmp_path / "other"))
    finally:
        project.close()


def test_the_jobs_of_slurm_say_what_they_are():
    for text in SHELL:
        assert subprocess.run(["bash", "-n"], input=text, text=True, check=False).returncode == 0
    (worker,) = re.findall(r"raybundle (worker .*)", SHELL[0])
    understood(shlex.split(worker))
    (run,) = re.findall(r"raybundle (orient .*) &&", SHELL[1])
    understood(shlex.split(run))
