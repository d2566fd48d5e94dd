"""`seamline serve` behind nginx, as `seamline serve --nginx` configures it, on this machine alone. Only what names this host is changed in the
written configuration: ports, certificate, folders."""
import os
import shutil
import socket
import subprocess
import sys
import time

NGINX = shutil.which("nginx") or "/usr/sbin/nginx"
NAME = "study.example.org"


def skip_without_nginx():
    if not os.path.exists(NGINX) or not shutil.which("openssl"):
        print("skipped: no nginx or no openssl here (Debian: nginx-light openssl)")
        sys.exit(77)


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def reaches(port):
    with socket.socket() as probe:
        return probe.connect_ex(("127.0.0.1", port)) == 0


class BehindNginx:
    """A context: `outer` is nginx's port for https, `plain` for http, `inner` the server's own; `certificate` is to be trusted."""

    def __init__(self, program, work, page, rendered_set, log, more=()):
        self.program, self.work, self.log = program, work, log
        self.inner, self.outer, self.plain = free_port(), free_port(), free_port()
        self.certificate = self.path("fullchain.pem")
        os.makedirs(self.path("log"), exist_ok=True)
        subprocess.run([program, "serve", "--nginx", self.path("written.conf"), "--port", str(self.inner)], check=True, capture_output=True)
        subprocess.run(["openssl", "req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:P-256", "-nodes", "-days", "2", "-subj", "/CN=" + NAME,
                        "-addext", "subjectAltName=DNS:" + NAME, "-keyout", self.path("privkey.pem"), "-out", self.certificate],
                       check=True, capture_output=True)
        with open(self.path("written.conf")) as file:
            written = file.read()
        for old, new in {"listen 80;": f"listen 127.0.0.1:{self.plain};", "listen [::]:80;": "",
                         "listen 443 ssl http2;": f"listen 127.0.0.1:{self.outer} ssl http2;", "listen [::]:443 ssl http2;": "",
                         f"/etc/letsencrypt/live/{NAME}/": work + "/", "/var/log/nginx/": self.path("log/")}.items():
            assert old in written, old
            written = written.replace(old, new)
        folders = "".join(f"{kind}_temp_path {self.path('tmp_' + kind)};\n" for kind in ("client_body", "proxy", "fastcgi", "uwsgi", "scgi"))
        with open(self.path("nginx.conf"), "w") as file:
            # As nginx comes: 512 connections of one worker, Debian's 768.
            file.write(f"worker_processes 1;\npid {self.path('nginx.pid')};\nerror_log {self.path('log/of_nginx_itself.log')} emerg;\nevents {{}}\n"
                       f"http {{\naccess_log off;\n{folders}{written}}}\n")
        self.command = [program, "serve", page, "--log", log, "--set", rendered_set, "--port", str(self.inner),
                        "--host", NAME, *more]

    def path(self, name):
        return os.path.join(self.work, name)

    def said(self):
        with open(self.path("serve.txt")) as file:
            return file.read()

    def kept_by_nginx(self):
        kept = ""
        for name in sorted(os.listdir(self.path("log"))):
            with open(self.path("log/" + name)) as file:
                kept += file.read()
        return kept

    def __enter__(self):
        self.server = subprocess.Popen(self.command, stdout=open(self.path("serve.txt"), "w"), stderr=subprocess.STDOUT)
        self.proxy = subprocess.Popen([NGINX, "-c", self.path("nginx.conf"), "-p", self.work, "-g", "daemon off;"], stderr=subprocess.PIPE, text=True)
        for port in (self.inner, self.outer, self.plain):
            for _ in range(400):
                if reaches(port):
                    break
                assert self.proxy.poll() is None, self.proxy.stderr.read()
                assert self.server.poll() is None, self.said()
                time.sleep(0.05)
            assert reaches(port), port
        return self

    def __exit__(self, *of_an_exception):
        self.proxy.terminate()
        self.proxy.wait()
        self.server.terminate()
        assert self.server.wait(20) == 0 or of_an_exception[0], self.said()
