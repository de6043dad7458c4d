struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
}
struct type_6 {
member: array<f32>,
}
struct type_9 {
member: array<u32>,
}
struct type_11 {
member: type_4,
member_1: type_4,
member_2: type_4,
member_3: type_4,
member_4: type_4,
member_5: vec4<i32>,
member_6: vec4<i32>,
member_7: vec4<i32>,
}
struct type_12 {
member: vec4<u32>,
member_1: vec4<u32>,
member_2: vec4<u32>,
member_3: vec4<u32>,
member_4: type_4,
member_5: type_11,
member_6: type_11,
member_7: type_4,
member_8: type_4,
member_9: type_4,
member_10: type_4,
member_11: type_4,
member_12: type_4,
member_13: type_4,
member_14: type_4,
member_15: type_4,
member_16: type_4,
member_17: type_4,
member_18: type_4,
member_19: type_4,
member_20: type_4,
member_21: type_4,
member_22: type_4,
member_23: type_4,
member_24: type_4,
member_25: vec4<u32>,
member_26: type_4,
member_27: type_4,
member_28: type_4,
member_29: type_4,
member_30: type_4,
member_31: type_4,
}
struct type_13 {
member: type_12,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_13;
@group(0) @binding(2)
var<storage, read_write> global_2: type_6;
@group(0) @binding(1)
var<storage> global_3: type_9;
fn function_() {
var local: i32;
var phi_172_: u32;
var phi_178_: u32;
var phi_253_: u32;
var phi_259_: u32;
var phi_334_: u32;
var phi_340_: u32;
var phi_442_: u32;
var phi_448_: u32;
var phi_518_: u32;
var phi_524_: u32;
let _e37 = global;
let _e43 = global_1.member.member_1;
let _e46 = (_e37.x + _e43.x);
let _e49 = (_e37.y + _e43.y);
if (_e46 < _e43.z) {
if (_e49 < _e43.w) {
let _e57 = global_1.member.member[0u];
let _e61 = global_1.member.member[1u];
let _e62 = (_e57 * _e61);
let _e64 = ((_e49 * _e57) + _e46);
let _e68 = global_1.member.member_2[2u];
local = bitcast<i32>((((_e49 * _e68) + _e46) * 10u));
let _e73 = local;
let _e75 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e77 = select(_e75, _e73, (_e73 < _e75));
let _e82 = global_3.member[bitcast<u32>(select(0i, _e77, (_e77 > 0i)))];
let _e83 = (_e73 + 1i);
let _e85 = select(_e75, _e83, (_e83 < _e75));
let _e90 = global_3.member[bitcast<u32>(select(0i, _e85, (_e85 > 0i)))];
let _e93 = ((_e90 >> bitcast<u32>(31i)) != 0u);
if _e93 {
phi_172_ = (~(_e82) + 1u);
} else {
phi_172_ = _e82;
}
let _e99 = phi_172_;
if _e93 {
phi_178_ = (~(_e90) + select(0u, 1u, (_e82 == 0u)));
} else {
phi_178_ = _e90;
}
let _e103 = phi_178_;
let _e125 = ((((f32(bitcast<i32>(((_e103 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e103 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e99 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e99 & 65535u)))));
let _e131 = (1f / 16777216f);
let _e133 = (1f + (select(_e125, -(bitcast<f32>((bitcast<u32>(_e125) & 2147483647u))), _e93) * _e131));
let _e135 = select(0f, _e133, (_e133 > 0f));
let _e136 = local;
let _e137 = (_e136 + 2i);
let _e139 = select(_e75, _e137, (_e137 < _e75));
let _e144 = global_3.member[bitcast<u32>(select(0i, _e139, (_e139 > 0i)))];
let _e145 = (_e136 + 3i);
let _e147 = select(_e75, _e145, (_e145 < _e75));
let _e152 = global_3.member[bitcast<u32>(select(0i, _e147, (_e147 > 0i)))];
let _e155 = ((_e152 >> bitcast<u32>(31i)) != 0u);
if _e155 {
phi_253_ = (~(_e144) + 1u);
} else {
phi_253_ = _e144;
}
let _e161 = phi_253_;
if _e155 {
phi_259_ = (~(_e152) + select(0u, 1u, (_e144 == 0u)));
} else {
phi_259_ = _e152;
}
let _e165 = phi_259_;
let _e187 = ((((f32(bitcast<i32>(((_e165 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e165 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e161 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e161 & 65535u)))));
let _e194 = (1f + (select(_e187, -(bitcast<f32>((bitcast<u32>(_e187) & 2147483647u))), _e155) * _e131));
let _e196 = select(0f, _e194, (_e194 > 0f));
let _e197 = local;
let _e198 = (_e197 + 4i);
let _e200 = select(_e75, _e198, (_e198 < _e75));
let _e205 = global_3.member[bitcast<u32>(select(0i, _e200, (_e200 > 0i)))];
let _e206 = (_e197 + 5i);
let _e208 = select(_e75, _e206, (_e206 < _e75));
let _e213 = global_3.member[bitcast<u32>(select(0i, _e208, (_e208 > 0i)))];
let _e216 = ((_e213 >> bitcast<u32>(31i)) != 0u);
if _e216 {
phi_334_ = (~(_e205) + 1u);
} else {
phi_334_ = _e205;
}
let _e222 = phi_334_;
if _e216 {
phi_340_ = (~(_e213) + select(0u, 1u, (_e205 == 0u)));
} else {
phi_340_ = _e213;
}
let _e226 = phi_340_;
let _e248 = ((((f32(bitcast<i32>(((_e226 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e226 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e222 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e222 & 65535u)))));
let _e255 = (1f + (select(_e248, -(bitcast<f32>((bitcast<u32>(_e248) & 2147483647u))), _e216) * _e131));
let _e257 = select(0f, _e255, (_e255 > 0f));
let _e261 = (((_e135 + _e196) + _e257) * (1f / 3f));
let _e262 = (_e261 > 1e-6f);
let _e265 = select(0f, (1f / select(1e-6f, _e261, _e262)), _e262);
let _e269 = global_1.member.member_10.member;
let _e273 = global_1.member.member_10.member_1;
let _e277 = global_1.member.member_10.member_2;
let _e278 = local;
let _e279 = (_e278 + 6i);
let _e281 = select(_e75, _e279, (_e279 < _e75));
let _e286 = global_3.member[bitcast<u32>(select(0i, _e281, (_e281 > 0i)))];
let _e287 = (_e278 + 7i);
let _e289 = select(_e75, _e287, (_e287 < _e75));
let _e294 = global_3.member[bitcast<u32>(select(0i, _e289, (_e289 > 0i)))];
let _e297 = ((_e294 >> bitcast<u32>(31i)) != 0u);
if _e297 {
phi_442_ = (~(_e286) + 1u);
} else {
phi_442_ = _e286;
}
let _e303 = phi_442_;
if _e297 {
phi_448_ = (~(_e294) + select(0u, 1u, (_e286 == 0u)));
} else {
phi_448_ = _e294;
}
let _e307 = phi_448_;
let _e329 = ((((f32(bitcast<i32>(((_e307 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e307 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e303 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e303 & 65535u)))));
let _e335 = (1f / 8388608f);
let _e338 = local;
let _e339 = (_e338 + 8i);
let _e341 = select(_e75, _e339, (_e339 < _e75));
let _e346 = global_3.member[bitcast<u32>(select(0i, _e341, (_e341 > 0i)))];
let _e347 = (_e338 + 9i);
let _e349 = select(_e75, _e347, (_e347 < _e75));
let _e354 = global_3.member[bitcast<u32>(select(0i, _e349, (_e349 > 0i)))];
let _e357 = ((_e354 >> bitcast<u32>(31i)) != 0u);
if _e357 {
phi_518_ = (~(_e346) + 1u);
} else {
phi_518_ = _e346;
}
let _e363 = phi_518_;
if _e357 {
phi_524_ = (~(_e354) + select(0u, 1u, (_e346 == 0u)));
} else {
phi_524_ = _e354;
}
let _e367 = phi_524_;
let _e389 = ((((f32(bitcast<i32>(((_e367 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e367 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e363 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e363 & 65535u)))));
global_2.member[_e64] = _e135;
global_2.member[(_e62 + _e64)] = _e196;
global_2.member[((2u * _e62) + _e64)] = _e257;
global_2.member[((3u * _e62) + _e64)] = (_e269 + (((select(_e329, -(bitcast<f32>((bitcast<u32>(_e329) & 2147483647u))), _e297) * _e335) * _e265) * _e277));
global_2.member[((4u * _e62) + _e64)] = (_e273 + (((select(_e389, -(bitcast<f32>((bitcast<u32>(_e389) & 2147483647u))), _e357) * _e335) * _e265) * _e277));
global_2.member[((5u * _e62) + _e64)] = _e277;
global_2.member[((6u * _e62) + _e64)] = 0f;
global_2.member[((7u * _e62) + _e64)] = 0f;
global_2.member[((8u * _e62) + _e64)] = 1f;
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
