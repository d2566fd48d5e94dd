// HAnim for X3DOM, whose plain build does not know it: joints are transforms, and the skin follows them as X3D 4.0 says:
// a vertex is the sum of where each of its joints carries it, times the joint's weight.
(() => {
  "use strict";
  const { Transform, Group, X3DChildNode, X3DCoordinateNode, Normal } = x3dom.nodeTypes;

  function define(name, base, fields, methods) {
    x3dom.registerNodeType(name, "HAnim", defineClass(base, function (context) {
      base.call(this, context);
      this.addField_SFString(context, "name", "");
      fields.call(this, context);
    }, methods));
  }

  define("HAnimSegment", Group, () => {}, {});
  define("HAnimSite", Transform, () => {}, {});
  define("HAnimJoint", Transform, function (context) {
    this.addField_MFInt32(context, "skinCoordIndex", []);
    this.addField_MFFloat(context, "skinCoordWeight", []);
    const { translation, rotation, scale, scaleOrientation } = this._vf;
    this.exported = { translation, rotation, scale, scaleOrientation };
    this.has_moved = true;
  }, {
    fieldChanged(name) {
      Transform.prototype.fieldChanged.call(this, name);
      this.has_moved = true;
    },
  });

  /** Joints below a node, each with the matrix from the figure's own frame to where it carries what it holds. */
  function carried(node, above, out) {
    for (const joint of node._childNodes)
      if (joint instanceof x3dom.nodeTypes.HAnimJoint) {
        const matrix = above.mult(joint._trafo);
        out.push([joint, matrix]);
        carried(joint, matrix, out);
      }
    return out;
  }

  const numbers = (vectors) => Float32Array.from(vectors.flatMap((v) => [v.x, v.y, v.z]));

  define("HAnimHumanoid", Transform, function (context) {
    this.addField_SFString(context, "version", "");
    this.addField_MFString(context, "info", []);
    for (const name of ["skeleton", "joints", "segments", "skin"]) this.addField_MFNode(name, X3DChildNode);
    this.addField_SFNode("skinCoord", X3DCoordinateNode);
    this.addField_SFNode("skinNormal", Normal);
  }, {
    tick() {
      const joints = carried({ _childNodes: this._cf.skeleton.nodes }, x3dom.fields.SFMatrix4f.identity(), []);
      if (!joints.some(([joint]) => joint.has_moved)) return false;
      for (const [joint] of joints) joint.has_moved = false;
      this.bend(joints, this._cf.skinCoord.node, "point", 1);
      this.bend(joints, this._cf.skinNormal.node, "vector", 0);
      return true;
    },
    /** `places`: 1 of points, 0 of directions. */
    bend(joints, node, field, places) {
      if (!node) return;
      const values = node._vf[field];
      node.bound ??= numbers(Array.from(values));
      const from = node.bound, to = new Float32Array(from.length);
      for (const [joint, m] of joints) {
        const { skinCoordIndex: index, skinCoordWeight: weight } = joint._vf;
        for (let i = 0; i < index.length; ++i) {
          const at = 3 * index[i], w = weight[i], x = from[at], y = from[at + 1], z = from[at + 2];
          to[at] += w * (m._00 * x + m._01 * y + m._02 * z + places * m._03);
          to[at + 1] += w * (m._10 * x + m._11 * y + m._12 * z + places * m._13);
          to[at + 2] += w * (m._20 * x + m._21 * y + m._22 * z + places * m._23);
        }
      }
      for (let i = 0; i < values.length; ++i) {
        const length = places ? 1 : Math.hypot(to[3 * i], to[3 * i + 1], to[3 * i + 2]) || 1;
        values[i].setValues({ x: to[3 * i] / length, y: to[3 * i + 1] / length, z: to[3 * i + 2] / length });
      }
      node.fieldChanged(field);
    },
    /** Puts every joint where the file had it. */
    stand() {
      for (const [joint] of carried({ _childNodes: this._cf.skeleton.nodes }, x3dom.fields.SFMatrix4f.identity(), [])) {
        Object.assign(joint._vf, joint.exported);
        joint.fieldChanged("rotation");
      }
    },
  });

  // While it moves, nothing says where its own shadow falls on it: the map is of the exported pose.
  const control = document.getElementById("moves"), clock = document.getElementById("figure_clock");
  const corners = document.querySelectorAll('#object field[name="object_corner_m"]');
  for (const corner of corners) corner.dataset.exported = corner.getAttribute("value");
  function move() {
    clock.setAttribute("enabled", String(control.checked));
    for (const corner of corners) corner.setAttribute("value", control.checked ? "1e9 1e9" : corner.dataset.exported);
    if (!control.checked) document.getElementById("figure")._x3domNode?.stand();
  }
  if (control) {
    control.checked = !matchMedia("(prefers-reduced-motion: reduce)").matches;
    control.addEventListener("change", move);
    move();
  }
})();
