struct type_2 {
member: u32,
member_1: u32,
member_2: u32,
}
struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
}
struct type_7 {
member: array<u32>,
}
struct type_8 {
member: type_2,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
member_10: type_4,
member_11: type_4,
member_12: f32,
}
struct type_9 {
member: type_8,
}
struct type_12 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(2)
var<storage, read_write> global_1: type_12;
@group(0) @binding(0)
var<storage> global_2: type_9;
@group(0) @binding(1)
var<storage> global_3: type_7;
fn function_() {
var phi_141_: i32;
var phi_144_: i32;
var phi_142_: i32;
var phi_145_: i32;
var local: i32;
var local_1: i32;
var phi_177_: i32;
var phi_180_: type_2;
var local_2: i32;
var local_3: i32;
var phi_250_: u32;
var phi_265_: u32;
var phi_271_: u32;
var phi_383_: type_2;
var local_4: i32;
var phi_446_: u32;
var phi_461_: u32;
var phi_467_: u32;
var phi_579_: type_2;
var phi_178_: i32;
var phi_181_: type_2;
let _e42 = global;
let _e49 = global_2.member.member;
if (_e42.x < _e49.member) {
if (_e42.y < _e49.member_1) {
let _e60 = global_2.member.member.member;
let _e62 = ((_e42.y * _e60) + _e42.x);
let _e65 = global_2.member.member_1;
if (_e62 < _e65) {
let _e69 = global_2.member.member_3;
let _e72 = global_2.member.member_4;
let _e74 = bitcast<i32>((_e69 * _e72));
phi_141_ = bitcast<i32>(_e62);
phi_144_ = 0i;
loop {
let _e77 = phi_141_;
let _e79 = phi_144_;
local = _e79;
local_1 = _e77;
local_2 = _e77;
local_3 = _e79;
local_4 = _e79;
let _e80 = (_e77 >= _e74);
if _e80 {
phi_142_ = (_e77 - _e74);
phi_145_ = (_e79 + 1i);
} else {
phi_142_ = i32();
phi_145_ = i32();
}
let _e84 = phi_142_;
let _e86 = phi_145_;
continue;
continuing {
phi_141_ = _e84;
phi_144_ = _e86;
break if !(_e80);
}
}
let _e90 = global_2.member.member_2;
let _e91 = bitcast<i32>(_e90);
let _e95 = bitcast<i32>(((_e90 + 2u) >> bitcast<u32>(1i)));
let _e98 = global_2.member.member_6;
let _e101 = local;
let _e105 = global_2.member.member_5;
let _e111 = local_1;
phi_177_ = 0i;
phi_180_ = type_2(0u, 0u, 65535u);
loop {
let _e115 = phi_177_;
let _e117 = phi_180_;
let _e118 = (_e115 < _e95);
if _e118 {
let _e119 = (2i * _e115);
let _e122 = local_2;
let _e123 = (_e122 * _e91);
let _e128 = global_2.member.member_7;
let _e129 = bitcast<i32>(_e128);
let _e133 = local_3;
let _e135 = ((((_e123 + _e119) * _e129) + _e133) * 2i);
let _e137 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e139 = select(_e137, _e135, (_e135 < _e137));
let _e145 = global_3.member[bitcast<u32>(select(0i, _e139, (_e139 > 0i)))];
let _e146 = (_e135 + 1i);
let _e148 = select(_e137, _e146, (_e146 < _e137));
let _e154 = global_3.member[bitcast<u32>(select(0i, _e148, (_e148 > 0i)))];
if ((_e119 < _e91) && ((_e145 | _e154) != 0u)) {
let _e159 = (_e49.member_2 == 1u);
if _e159 {
let _e162 = global_2.member.member_9;
phi_250_ = _e162;
} else {
phi_250_ = _e145;
}
let _e164 = phi_250_;
let _e166 = (_e117.member + _e164);
let _e170 = ((_e117.member_1 + select(_e154, 0u, _e159)) + select(0u, 1u, (_e166 < _e117.member)));
let _e173 = ((_e170 >> bitcast<u32>(31i)) != 0u);
if _e173 {
phi_265_ = (~(_e166) + 1u);
} else {
phi_265_ = _e166;
}
let _e179 = phi_265_;
if _e173 {
phi_271_ = (~(_e170) + select(0u, 1u, (_e166 == 0u)));
} else {
phi_271_ = _e170;
}
let _e183 = phi_271_;
let _e205 = ((((f32(bitcast<i32>(((_e183 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e183 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e179 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e179 & 65535u)))));
let _e213 = -((select(_e205, -(bitcast<f32>((bitcast<u32>(_e205) & 2147483647u))), _e173) * (1f / 16777216f)));
let _e215 = select(-87f, _e213, (_e213 > -87f));
let _e217 = select(88f, _e215, (_e215 < 88f));
let _e219 = ((_e217 * 1.442695f) + 0.5f);
let _e221 = select(-127f, _e219, (_e219 > -127f));
let _e223 = select(128f, _e221, (_e221 < 128f));
let _e230 = select(0i, select(select(i32(_e223), i32(-2147483648), (_e223 < -2147483600f)), 2147483647i, (_e223 > 2147483500f)), (_e223 == _e223));
let _e234 = (_e230 - select(0i, 1i, (_e223 < f32(_e230))));
let _e235 = f32(_e234);
let _e239 = ((_e217 - (_e235 * 0.6933594f)) - (_e235 * -2.1219444e-4f));
let _e261 = ((((1f + (_e239 * (1f + (_e239 * (0.5f + (_e239 * (0.16666667f + (_e239 * (0.041666668f + (_e239 * (0.008333334f + (_e239 * (0.001388889f + (_e239 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e234 + 127i)) << bitcast<u32>(23i)))) * 65535f) + 0.5f);
let _e263 = select(0f, _e261, (_e261 > 0f));
let _e265 = select(65535f, _e263, (_e263 < 65535f));
let _e272 = select(0i, select(select(i32(_e265), i32(-2147483648), (_e265 < -2147483600f)), 2147483647i, (_e265 > 2147483500f)), (_e265 == _e265));
phi_383_ = type_2(_e166, _e170, bitcast<u32>((_e272 - select(0i, 1i, (_e265 < f32(_e272))))));
} else {
phi_383_ = _e117;
}
let _e280 = phi_383_;
let _e282 = (_e119 + 1i);
let _e288 = local_4;
let _e290 = ((((_e123 + _e282) * _e129) + _e288) * 2i);
let _e292 = select(_e137, _e290, (_e290 < _e137));
let _e298 = global_3.member[bitcast<u32>(select(0i, _e292, (_e292 > 0i)))];
let _e299 = (_e290 + 1i);
let _e301 = select(_e137, _e299, (_e299 < _e137));
let _e307 = global_3.member[bitcast<u32>(select(0i, _e301, (_e301 > 0i)))];
if ((_e282 < _e91) && ((_e298 | _e307) != 0u)) {
let _e312 = (_e49.member_2 == 1u);
if _e312 {
let _e315 = global_2.member.member_9;
phi_446_ = _e315;
} else {
phi_446_ = _e298;
}
let _e317 = phi_446_;
let _e319 = (_e280.member + _e317);
let _e323 = ((_e280.member_1 + select(_e307, 0u, _e312)) + select(0u, 1u, (_e319 < _e280.member)));
let _e326 = ((_e323 >> bitcast<u32>(31i)) != 0u);
if _e326 {
phi_461_ = (~(_e319) + 1u);
} else {
phi_461_ = _e319;
}
let _e332 = phi_461_;
if _e326 {
phi_467_ = (~(_e323) + select(0u, 1u, (_e319 == 0u)));
} else {
phi_467_ = _e323;
}
let _e336 = phi_467_;
let _e358 = ((((f32(bitcast<i32>(((_e336 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e336 & 65535u)))) * 4294967300f) + ((f32(bitcast<i32>(((_e332 >> bitcast<u32>(16i)) & 65535u))) * 65536f) + f32(bitcast<i32>((_e332 & 65535u)))));
let _e366 = -((select(_e358, -(bitcast<f32>((bitcast<u32>(_e358) & 2147483647u))), _e326) * (1f / 16777216f)));
let _e368 = select(-87f, _e366, (_e366 > -87f));
let _e370 = select(88f, _e368, (_e368 < 88f));
let _e372 = ((_e370 * 1.442695f) + 0.5f);
let _e374 = select(-127f, _e372, (_e372 > -127f));
let _e376 = select(128f, _e374, (_e374 < 128f));
let _e383 = select(0i, select(select(i32(_e376), i32(-2147483648), (_e376 < -2147483600f)), 2147483647i, (_e376 > 2147483500f)), (_e376 == _e376));
let _e387 = (_e383 - select(0i, 1i, (_e376 < f32(_e383))));
let _e388 = f32(_e387);
let _e392 = ((_e370 - (_e388 * 0.6933594f)) - (_e388 * -2.1219444e-4f));
let _e414 = ((((1f + (_e392 * (1f + (_e392 * (0.5f + (_e392 * (0.16666667f + (_e392 * (0.041666668f + (_e392 * (0.008333334f + (_e392 * (0.001388889f + (_e392 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e387 + 127i)) << bitcast<u32>(23i)))) * 65535f) + 0.5f);
let _e416 = select(0f, _e414, (_e414 > 0f));
let _e418 = select(65535f, _e416, (_e416 < 65535f));
let _e425 = select(0i, select(select(i32(_e418), i32(-2147483648), (_e418 < -2147483600f)), 2147483647i, (_e418 > 2147483500f)), (_e418 == _e418));
phi_579_ = type_2(_e319, _e323, bitcast<u32>((_e425 - select(0i, 1i, (_e418 < f32(_e425))))));
} else {
phi_579_ = _e280;
}
let _e433 = phi_579_;
let _e435 = bitcast<u32>(((((((_e101 * bitcast<i32>(_e98)) + bitcast<i32>(_e105)) * bitcast<i32>(_e69)) + _e111) * _e95) + _e115));
if (_e435 < arrayLength((&global_1.member))) {
let _e442 = atomicAdd((&global_1.member[_e435]), (_e117.member_2 | (_e280.member_2 << bitcast<u32>(16i))));
}
phi_178_ = (_e115 + 1i);
phi_181_ = _e433;
} else {
phi_178_ = i32();
phi_181_ = type_2();
}
let _e445 = phi_178_;
let _e447 = phi_181_;
continue;
continuing {
phi_177_ = _e445;
phi_180_ = _e447;
break if !(_e118);
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
