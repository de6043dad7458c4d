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
member: type_4,
member_1: type_4,
member_2: type_4,
member_3: type_4,
member_4: type_4,
member_5: vec4<i32>,
member_6: vec4<i32>,
member_7: vec4<i32>,
}
struct type_10 {
member: vec4<u32>,
member_1: vec4<u32>,
member_2: vec4<u32>,
member_3: vec4<u32>,
member_4: type_4,
member_5: type_9,
member_6: type_9,
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
struct type_11 {
member: type_10,
}
struct type_12 {
member: u32,
member_1: u32,
member_2: f32,
member_3: f32,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_11;
@group(0) @binding(1)
var<storage> global_2: type_6;
@group(0) @binding(2)
var<storage, read_write> global_3: type_6;
fn function_() {
var local: u32;
var local_1: i32;
var local_2: i32;
var local_3: type_12;
var phi_295_: i32;
var phi_338_: i32;
var phi_531_: i32;
var phi_574_: i32;
var phi_767_: i32;
var phi_810_: i32;
let _e26 = global;
let _e33 = global_1.member.member_1;
let _e36 = (_e26.x + _e33.x);
let _e39 = (_e26.y + _e33.y);
if (_e36 < _e33.z) {
if (_e39 < _e33.w) {
let _e47 = global_1.member.member[0u];
let _e51 = global_1.member.member[1u];
let _e54 = ((_e39 * _e47) + _e36);
local = _e36;
let _e58 = global_1.member.member_2[2u];
local_1 = bitcast<i32>((_e39 * _e58));
let _e64 = global_1.member.member_2[3u];
local_2 = bitcast<i32>((_e58 * _e64));
let _e67 = local_2;
let _e69 = local_1;
let _e71 = local;
let _e73 = (((3i * _e67) + _e69) + bitcast<i32>(_e71));
let _e75 = (bitcast<i32>(arrayLength((&global_2.member))) - 1i);
let _e77 = select(_e75, _e73, (_e73 < _e75));
let _e82 = global_2.member[bitcast<u32>(select(0i, _e77, (_e77 > 0i)))];
let _e83 = local_2;
let _e85 = local_1;
let _e87 = local;
let _e89 = (((4i * _e83) + _e85) + bitcast<i32>(_e87));
let _e91 = select(_e75, _e89, (_e89 < _e75));
let _e96 = global_2.member[bitcast<u32>(select(0i, _e91, (_e91 > 0i)))];
let _e97 = local_2;
let _e99 = local_1;
let _e101 = local;
let _e103 = (((5i * _e97) + _e99) + bitcast<i32>(_e101));
let _e105 = select(_e75, _e103, (_e103 < _e75));
let _e110 = global_2.member[bitcast<u32>(select(0i, _e105, (_e105 > 0i)))];
let _e114 = global_1.member.member_4.member_2;
let _e117 = (1f / select(1e-6f, _e110, (_e110 > 1e-6f)));
let _e121 = global_1.member.member_7.member_3;
let _e122 = (_e114 * _e121);
let _e127 = global_1.member.member_8.member;
let _e129 = (((_e82 * _e117) - _e127) * _e122);
let _e134 = global_1.member.member_8.member_1;
let _e136 = (((_e96 * _e117) - _e134) * _e122);
local_3.member = _e36;
local_3.member_1 = _e39;
local_3.member_2 = -(_e129);
local_3.member_3 = -(_e136);
let _e146 = global_1.member.member_10.member;
let _e149 = global_1.member.member_2[2u];
let _e150 = bitcast<i32>(_e149);
let _e153 = global_1.member.member_2[3u];
let _e155 = bitcast<i32>((_e149 * _e153));
let _e157 = local_3.member_1;
let _e160 = ((3i * _e155) + (bitcast<i32>(_e157) * _e150));
let _e161 = local_3.member_2;
let _e162 = -(32768f);
let _e164 = select(_e162, _e161, (_e161 > _e162));
let _e166 = select(32768f, _e164, (_e164 < 32768f));
let _e173 = select(0i, select(select(i32(_e166), i32(-2147483648), (_e166 < -2147483600f)), 2147483647i, (_e166 > 2147483500f)), (_e166 == _e166));
let _e177 = (_e173 - select(0i, 1i, (_e166 < f32(_e173))));
let _e179 = (_e161 - f32(_e177));
let _e180 = (_e177 < 0i);
if _e180 {
phi_295_ = (_e177 + 1i);
} else {
phi_295_ = _e177;
}
let _e183 = phi_295_;
let _e184 = select(1i, -1i, _e180);
let _e186 = select(_e179, (1f - _e179), _e180);
let _e187 = local_3.member_3;
let _e189 = select(_e162, _e187, (_e187 > _e162));
let _e191 = select(32768f, _e189, (_e189 < 32768f));
let _e198 = select(0i, select(select(i32(_e191), i32(-2147483648), (_e191 < -2147483600f)), 2147483647i, (_e191 > 2147483500f)), (_e191 == _e191));
let _e202 = (_e198 - select(0i, 1i, (_e191 < f32(_e198))));
let _e204 = (_e187 - f32(_e202));
let _e205 = (_e202 < 0i);
if _e205 {
phi_338_ = (_e202 + 1i);
} else {
phi_338_ = _e202;
}
let _e208 = phi_338_;
let _e214 = local_3.member;
let _e217 = (((_e160 + (_e208 * _e150)) + bitcast<i32>(_e214)) + _e183);
let _e219 = select(_e75, _e217, (_e217 < _e75));
let _e224 = global_2.member[bitcast<u32>(select(0i, _e219, (_e219 > 0i)))];
let _e225 = (_e217 + _e184);
let _e227 = select(_e75, _e225, (_e225 < _e75));
let _e232 = global_2.member[bitcast<u32>(select(0i, _e227, (_e227 > 0i)))];
let _e235 = (_e224 + ((_e232 - _e224) * _e186));
let _e239 = local_3.member;
let _e242 = (((_e160 + ((_e208 + select(1i, -1i, _e205)) * _e150)) + bitcast<i32>(_e239)) + _e183);
let _e244 = select(_e75, _e242, (_e242 < _e75));
let _e249 = global_2.member[bitcast<u32>(select(0i, _e244, (_e244 > 0i)))];
let _e250 = (_e242 + _e184);
let _e252 = select(_e75, _e250, (_e250 < _e75));
let _e257 = global_2.member[bitcast<u32>(select(0i, _e252, (_e252 > 0i)))];
let _e261 = local_3.member;
let _e264 = local_3.member_2;
let _e265 = (f32(bitcast<i32>(_e261)) + _e264);
let _e266 = local_3.member_1;
let _e269 = local_3.member_3;
let _e270 = (f32(bitcast<i32>(_e266)) + _e269);
let _e272 = (f32(_e150) - 1f);
let _e275 = (f32(bitcast<i32>(_e153)) - 1f);
let _e290 = global_1.member.member_10.member_1;
let _e292 = local_3.member_1;
let _e295 = ((4i * _e155) + (bitcast<i32>(_e292) * _e150));
let _e296 = local_3.member_2;
let _e298 = select(_e162, _e296, (_e296 > _e162));
let _e300 = select(32768f, _e298, (_e298 < 32768f));
let _e307 = select(0i, select(select(i32(_e300), i32(-2147483648), (_e300 < -2147483600f)), 2147483647i, (_e300 > 2147483500f)), (_e300 == _e300));
let _e311 = (_e307 - select(0i, 1i, (_e300 < f32(_e307))));
let _e313 = (_e296 - f32(_e311));
let _e314 = (_e311 < 0i);
if _e314 {
phi_531_ = (_e311 + 1i);
} else {
phi_531_ = _e311;
}
let _e317 = phi_531_;
let _e318 = select(1i, -1i, _e314);
let _e320 = select(_e313, (1f - _e313), _e314);
let _e321 = local_3.member_3;
let _e323 = select(_e162, _e321, (_e321 > _e162));
let _e325 = select(32768f, _e323, (_e323 < 32768f));
let _e332 = select(0i, select(select(i32(_e325), i32(-2147483648), (_e325 < -2147483600f)), 2147483647i, (_e325 > 2147483500f)), (_e325 == _e325));
let _e336 = (_e332 - select(0i, 1i, (_e325 < f32(_e332))));
let _e338 = (_e321 - f32(_e336));
let _e339 = (_e336 < 0i);
if _e339 {
phi_574_ = (_e336 + 1i);
} else {
phi_574_ = _e336;
}
let _e342 = phi_574_;
let _e348 = local_3.member;
let _e351 = (((_e295 + (_e342 * _e150)) + bitcast<i32>(_e348)) + _e317);
let _e353 = select(_e75, _e351, (_e351 < _e75));
let _e358 = global_2.member[bitcast<u32>(select(0i, _e353, (_e353 > 0i)))];
let _e359 = (_e351 + _e318);
let _e361 = select(_e75, _e359, (_e359 < _e75));
let _e366 = global_2.member[bitcast<u32>(select(0i, _e361, (_e361 > 0i)))];
let _e369 = (_e358 + ((_e366 - _e358) * _e320));
let _e373 = local_3.member;
let _e376 = (((_e295 + ((_e342 + select(1i, -1i, _e339)) * _e150)) + bitcast<i32>(_e373)) + _e317);
let _e378 = select(_e75, _e376, (_e376 < _e75));
let _e383 = global_2.member[bitcast<u32>(select(0i, _e378, (_e378 > 0i)))];
let _e384 = (_e376 + _e318);
let _e386 = select(_e75, _e384, (_e384 < _e75));
let _e391 = global_2.member[bitcast<u32>(select(0i, _e386, (_e386 > 0i)))];
let _e395 = local_3.member;
let _e398 = local_3.member_2;
let _e399 = (f32(bitcast<i32>(_e395)) + _e398);
let _e400 = local_3.member_1;
let _e403 = local_3.member_3;
let _e404 = (f32(bitcast<i32>(_e400)) + _e403);
let _e419 = global_1.member.member_10.member_2;
let _e421 = local_3.member_1;
let _e424 = ((5i * _e155) + (bitcast<i32>(_e421) * _e150));
let _e425 = local_3.member_2;
let _e427 = select(_e162, _e425, (_e425 > _e162));
let _e429 = select(32768f, _e427, (_e427 < 32768f));
let _e436 = select(0i, select(select(i32(_e429), i32(-2147483648), (_e429 < -2147483600f)), 2147483647i, (_e429 > 2147483500f)), (_e429 == _e429));
let _e440 = (_e436 - select(0i, 1i, (_e429 < f32(_e436))));
let _e442 = (_e425 - f32(_e440));
let _e443 = (_e440 < 0i);
if _e443 {
phi_767_ = (_e440 + 1i);
} else {
phi_767_ = _e440;
}
let _e446 = phi_767_;
let _e447 = select(1i, -1i, _e443);
let _e449 = select(_e442, (1f - _e442), _e443);
let _e450 = local_3.member_3;
let _e452 = select(_e162, _e450, (_e450 > _e162));
let _e454 = select(32768f, _e452, (_e452 < 32768f));
let _e461 = select(0i, select(select(i32(_e454), i32(-2147483648), (_e454 < -2147483600f)), 2147483647i, (_e454 > 2147483500f)), (_e454 == _e454));
let _e465 = (_e461 - select(0i, 1i, (_e454 < f32(_e461))));
let _e467 = (_e450 - f32(_e465));
let _e468 = (_e465 < 0i);
if _e468 {
phi_810_ = (_e465 + 1i);
} else {
phi_810_ = _e465;
}
let _e471 = phi_810_;
let _e477 = local_3.member;
let _e480 = (((_e424 + (_e471 * _e150)) + bitcast<i32>(_e477)) + _e446);
let _e482 = select(_e75, _e480, (_e480 < _e75));
let _e487 = global_2.member[bitcast<u32>(select(0i, _e482, (_e482 > 0i)))];
let _e488 = (_e480 + _e447);
let _e490 = select(_e75, _e488, (_e488 < _e75));
let _e495 = global_2.member[bitcast<u32>(select(0i, _e490, (_e490 > 0i)))];
let _e498 = (_e487 + ((_e495 - _e487) * _e449));
let _e502 = local_3.member;
let _e505 = (((_e424 + ((_e471 + select(1i, -1i, _e468)) * _e150)) + bitcast<i32>(_e502)) + _e446);
let _e507 = select(_e75, _e505, (_e505 < _e75));
let _e512 = global_2.member[bitcast<u32>(select(0i, _e507, (_e507 > 0i)))];
let _e513 = (_e505 + _e447);
let _e515 = select(_e75, _e513, (_e513 < _e75));
let _e520 = global_2.member[bitcast<u32>(select(0i, _e515, (_e515 > 0i)))];
let _e524 = local_3.member;
let _e527 = local_3.member_2;
let _e528 = (f32(bitcast<i32>(_e524)) + _e527);
let _e529 = local_3.member_1;
let _e532 = local_3.member_3;
let _e533 = (f32(bitcast<i32>(_e529)) + _e532);
let _e544 = select(_e419, (_e498 + (((_e512 + ((_e520 - _e512) * _e449)) - _e498) * select(_e467, (1f - _e467), _e468))), ((((_e528 >= 0f) && (_e528 <= _e272)) && (_e533 >= 0f)) && (_e533 <= _e275)));
let _e547 = (1f / select(1e-6f, _e544, (_e544 > 1e-6f)));
let _e557 = global_1.member.member[3u];
let _e559 = ((_e557 & 1u) != 0u);
global_3.member[_e54] = select((((select(_e146, (_e235 + (((_e249 + ((_e257 - _e249) * _e186)) - _e235) * select(_e204, (1f - _e204), _e205))), ((((_e265 >= 0f) && (_e265 <= _e272)) && (_e270 >= 0f)) && (_e270 <= _e275))) * _e547) - _e127) * _e122), _e129, _e559);
global_3.member[((_e47 * _e51) + _e54)] = select((((select(_e290, (_e369 + (((_e383 + ((_e391 - _e383) * _e320)) - _e369) * select(_e338, (1f - _e338), _e339))), ((((_e399 >= 0f) && (_e399 <= _e272)) && (_e404 >= 0f)) && (_e404 <= _e275))) * _e547) - _e134) * _e122), _e136, _e559);
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
