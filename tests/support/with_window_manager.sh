#!/bin/sh
# SPDX-License-Identifier: MIT
# Runs a program on the X server of $DISPLAY under a small window manager, as a user who has just come would:
# with a home of its own. Alt and the mouse are left to the program.
home=$(mktemp -d)
mkdir -m 700 "$home/runtime"
cat >"$home/openbox.xml" <<'XML'
<openbox_config xmlns="http://openbox.org/3.4/rc">
  <placement><policy>Smart</policy></placement>
  <keyboard/>
  <mouse>
    <context name="Client">
      <mousebind button="Left" action="Press"><action name="Focus"/><action name="Raise"/></mousebind>
      <mousebind button="Middle" action="Press"><action name="Focus"/><action name="Raise"/></mousebind>
      <mousebind button="Right" action="Press"><action name="Focus"/><action name="Raise"/></mousebind>
    </context>
  </mouse>
</openbox_config>
XML
HOME=$home XDG_RUNTIME_DIR=$home/runtime
export HOME XDG_RUNTIME_DIR
unset XDG_CONFIG_HOME XDG_DATA_HOME XDG_CACHE_HOME
openbox --config-file "$home/openbox.xml" --startup "touch '$home/ready'" 2>/dev/null &
manager=$!
# A window that is there before the manager is never given the focus.
while [ ! -e "$home/ready" ] && kill -0 $manager 2>/dev/null; do sleep 0.05; done
"$@"
code=$?
kill $manager
rm -rf "$home"
exit $code
