struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
}
struct type_7 {
member: array<u32>,
}
struct type_8 {
member: vec4<u32>,
member_1: vec4<u32>,
member_2: vec4<u32>,
member_3: type_4,
}
struct type_9 {
member: type_8,
}
struct type_10 {
member: u32,
member_1: u32,
member_2: u32,
}
struct type_13 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_9;
@group(0) @binding(1)
var<storage> global_2: type_7;
@group(0) @binding(2)
var<storage, read_write> global_3: type_13;
fn function_() {
var phi_137_: i32;
var phi_140_: i32;
var phi_138_: i32;
var phi_141_: i32;
var local: i32;
var local_1: i32;
var phi_178_: i32;
var phi_181_: type_10;
var local_2: i32;
var local_3: i32;
var phi_254_: u32;
var phi_269_: u32;
var phi_275_: u32;
var phi_387_: type_10;
var local_4: i32;
var phi_453_: u32;
var phi_468_: u32;
var phi_474_: u32;
var phi_586_: type_10;
var phi_179_: i32;
var phi_182_: type_10;
let _e43 = global;
let _e51 = global_1.member.member[0u];
let _e55 = global_1.member.member[1u];
if (_e43.x < _e51) {
if (_e43.y < _e55) {
let _e63 = global_1.member.member[2u];
let _e65 = ((_e43.y * _e51) + _e43.x);
let _e69 = global_1.member.member[3u];
if (_e65 < _e69) {
let _e74 = global_1.member.member_1[1u];
let _e78 = global_1.member.member_1[2u];
let _e80 = bitcast<i32>((_e74 * _e78));
phi_137_ = bitcast<i32>(_e65);
phi_140_ = 0i;
loop {
let _e83 = phi_137_;
let _e85 = phi_140_;
local = _e85;
local_1 = _e83;
local_2 = _e83;
local_3 = _e85;
local_4 = _e85;
let _e86 = (_e83 >= _e80);
if _e86 {
phi_138_ = (_e83 - _e80);
phi_141_ = (_e85 + 1i);
} else {
phi_138_ = i32();
phi_141_ = i32();
}
let _e90 = phi_138_;
let _e92 = phi_141_;
continue;
continuing {
phi_137_ = _e90;
phi_140_ = _e92;
break if !(_e86);
}
}
let _e97 = global_1.member.member_1[0u];
let _e98 = bitcast<i32>(_e97);
let _e102 = bitcast<i32>(((_e97 + 2u) >> bitcast<u32>(1i)));
let _e106 = global_1.member.member_2[1u];
let _e109 = local;
let _e114 = global_1.member.member_1[3u];
let _e120 = local_1;
phi_178_ = 0i;
phi_181_ = type_10(0u, 0u, 65535u);
loop {
let _e124 = phi_178_;
let _e126 = phi_181_;
let _e127 = (_e124 < _e102);
if _e127 {
let _e128 = (2i * _e124);
let _e131 = local_2;
let _e132 = (_e131 * _e98);
let _e138 = global_1.member.member_2[0u];
let _e139 = bitcast<i32>(_e138);
let _e143 = local_3;
let _e145 = ((((_e132 + _e128) * _e139) + _e143) * 2i);
let _e147 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e149 = select(_e147, _e145, (_e145 < _e147));
let _e155 = global_2.member[bitcast<u32>(select(0i, _e149, (_e149 > 0i)))];
let _e156 = (_e145 + 1i);
let _e158 = select(_e147, _e156, (_e156 < _e147));
let _e164 = global_2.member[bitcast<u32>(select(0i, _e158, (_e158 > 0i)))];
if ((_e128 < _e98) && ((_e155 | _e164) != 0u)) {
let _e169 = (_e63 == 1u);
if _e169 {
let _e173 = global_1.member.member_2[3u];
phi_254_ = _e173;
} else {
phi_254_ = _e155;
}
let _e175 = phi_254_;
let _e177 = (_e126.member + _e175);
let _e181 = ((_e126.member_1 + select(_e164, 0u, _e169)) + select(0u, 1u, (_e177 < _e126.member)));
let _e184 = ((_e181 >> bitcast<u32>(31i)) != 0u);
if _e184 {
phi_269_ = (~(_e177) + 1u);
} else {
phi_269_ = _e177;
}
let _e190 = phi_269_;
if _e184 {
phi_275_ = (~(_e181) + select(0u, 1u, (_e177 == 0u)));
} else {
phi_275_ = _e181;
}
let _e194 = phi_275_;
let _e216 = ((((f32(bitcast<i32>(((_e194 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e194 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e190 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e190 & 65535u)))));
let _e224 = -((select(_e216, -(bitcast<f32>((bitcast<u32>(_e216) & 2147483647u))), _e184) * (1f / 16777216f)));
let _e226 = select(-87f, _e224, (_e224 > -87f));
let _e228 = select(88f, _e226, (_e226 < 88f));
let _e230 = ((_e228 * 1.442695f) + 0.5f);
let _e232 = select(-127f, _e230, (_e230 > -127f));
let _e234 = select(128f, _e232, (_e232 < 128f));
let _e241 = select(0i, select(select(i32(_e234), i32(-2147483648), (_e234 < -2147483600f)), 2147483647i, (_e234 > 2147483500f)), (_e234 == _e234));
let _e245 = (_e241 - select(0i, 1i, (_e234 < f32(_e241))));
let _e246 = f32(_e245);
let _e250 = ((_e228 - (_e246 * 0.6933594f)) - (_e246 * -2.1219444e-4f));
let _e272 = ((((1f + (_e250 * (1f + (_e250 * (0.5f + (_e250 * (0.16666667f + (_e250 * (0.041666668f + (_e250 * (0.008333334f + (_e250 * (0.001388889f + (_e250 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e245 + 127i)) << bitcast<u32>(23i)))) * 65535f) + 0.5f);
let _e274 = select(0f, _e272, (_e272 > 0f));
let _e276 = select(65535f, _e274, (_e274 < 65535f));
let _e283 = select(0i, select(select(i32(_e276), i32(-2147483648), (_e276 < -2147483600f)), 2147483647i, (_e276 > 2147483500f)), (_e276 == _e276));
phi_387_ = type_10(_e177, _e181, bitcast<u32>((_e283 - select(0i, 1i, (_e276 < f32(_e283))))));
} else {
phi_387_ = _e126;
}
let _e291 = phi_387_;
let _e293 = (_e128 + 1i);
let _e299 = local_4;
let _e301 = ((((_e132 + _e293) * _e139) + _e299) * 2i);
let _e303 = select(_e147, _e301, (_e301 < _e147));
let _e309 = global_2.member[bitcast<u32>(select(0i, _e303, (_e303 > 0i)))];
let _e310 = (_e301 + 1i);
let _e312 = select(_e147, _e310, (_e310 < _e147));
let _e318 = global_2.member[bitcast<u32>(select(0i, _e312, (_e312 > 0i)))];
if ((_e293 < _e98) && ((_e309 | _e318) != 0u)) {
let _e323 = (_e63 == 1u);
if _e323 {
let _e327 = global_1.member.member_2[3u];
phi_453_ = _e327;
} else {
phi_453_ = _e309;
}
let _e329 = phi_453_;
let _e331 = (_e291.member + _e329);
let _e335 = ((_e291.member_1 + select(_e318, 0u, _e323)) + select(0u, 1u, (_e331 < _e291.member)));
let _e338 = ((_e335 >> bitcast<u32>(31i)) != 0u);
if _e338 {
phi_468_ = (~(_e331) + 1u);
} else {
phi_468_ = _e331;
}
let _e344 = phi_468_;
if _e338 {
phi_474_ = (~(_e335) + select(0u, 1u, (_e331 == 0u)));
} else {
phi_474_ = _e335;
}
let _e348 = phi_474_;
let _e370 = ((((f32(bitcast<i32>(((_e348 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e348 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e344 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e344 & 65535u)))));
let _e378 = -((select(_e370, -(bitcast<f32>((bitcast<u32>(_e370) & 2147483647u))), _e338) * (1f / 16777216f)));
let _e380 = select(-87f, _e378, (_e378 > -87f));
let _e382 = select(88f, _e380, (_e380 < 88f));
let _e384 = ((_e382 * 1.442695f) + 0.5f);
let _e386 = select(-127f, _e384, (_e384 > -127f));
let _e388 = select(128f, _e386, (_e386 < 128f));
let _e395 = select(0i, select(select(i32(_e388), i32(-2147483648), (_e388 < -2147483600f)), 2147483647i, (_e388 > 2147483500f)), (_e388 == _e388));
let _e399 = (_e395 - select(0i, 1i, (_e388 < f32(_e395))));
let _e400 = f32(_e399);
let _e404 = ((_e382 - (_e400 * 0.6933594f)) - (_e400 * -2.1219444e-4f));
let _e426 = ((((1f + (_e404 * (1f + (_e404 * (0.5f + (_e404 * (0.16666667f + (_e404 * (0.041666668f + (_e404 * (0.008333334f + (_e404 * (0.001388889f + (_e404 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e399 + 127i)) << bitcast<u32>(23i)))) * 65535f) + 0.5f);
let _e428 = select(0f, _e426, (_e426 > 0f));
let _e430 = select(65535f, _e428, (_e428 < 65535f));
let _e437 = select(0i, select(select(i32(_e430), i32(-2147483648), (_e430 < -2147483600f)), 2147483647i, (_e430 > 2147483500f)), (_e430 == _e430));
phi_586_ = type_10(_e331, _e335, bitcast<u32>((_e437 - select(0i, 1i, (_e430 < f32(_e437))))));
} else {
phi_586_ = _e291;
}
let _e445 = phi_586_;
let _e447 = bitcast<u32>(((((((_e109 * bitcast<i32>(_e106)) + bitcast<i32>(_e114)) * bitcast<i32>(_e74)) + _e120) * _e102) + _e124));
if (_e447 < arrayLength((&global_3.member))) {
let _e454 = atomicAdd((&global_3.member[_e447]), (_e126.member_2 | (_e291.member_2 << bitcast<u32>(16i))));
}
phi_179_ = (_e124 + 1i);
phi_182_ = _e445;
} else {
phi_179_ = i32();
phi_182_ = type_10();
}
let _e457 = phi_179_;
let _e459 = phi_182_;
continue;
continuing {
phi_178_ = _e457;
phi_181_ = _e459;
break if !(_e127);
}
}
}
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
