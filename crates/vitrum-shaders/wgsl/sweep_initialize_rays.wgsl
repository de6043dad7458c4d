struct type_2 {
member: u32,
member_1: u32,
member_2: u32,
}
struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_5 {
member: f32,
member_1: f32,
member_2: f32,
}
struct type_6 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
member_10: f32,
member_11: f32,
member_12: f32,
}
struct type_7 {
member: type_5,
member_1: f32,
}
struct type_8 {
member: type_7,
member_1: type_5,
}
struct type_9 {
member: type_8,
member_1: type_8,
}
struct type_11 {
member: array<f32>,
}
struct type_14 {
member: u32,
member_1: u32,
}
struct type_16 {
member: array<u32>,
}
struct type_17 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
}
struct type_18 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
}
struct type_19 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: type_5,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: i32,
member_8: i32,
member_9: type_2,
member_10: u32,
member_11: type_2,
member_12: u32,
}
struct type_20 {
member: u32,
member_1: u32,
member_2: f32,
member_3: f32,
member_4: f32,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
}
struct type_21 {
member: type_5,
member_1: type_5,
}
struct type_22 {
member: type_14,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
}
struct type_23 {
member: type_7,
member_1: type_7,
member_2: type_7,
member_3: u32,
member_4: type_14,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
member_9: f32,
member_10: f32,
member_11: f32,
member_12: u32,
member_13: u32,
member_14: type_2,
member_15: u32,
member_16: u32,
member_17: type_22,
member_18: type_5,
member_19: f32,
member_20: f32,
member_21: f32,
}
struct type_24 {
member: type_7,
member_1: u32,
}
struct type_25 {
member: type_2,
member_1: u32,
member_2: type_17,
member_3: type_14,
member_4: u32,
member_5: type_18,
member_6: type_19,
member_7: type_19,
member_8: type_20,
member_9: type_21,
member_10: type_23,
member_11: type_18,
member_12: type_4,
member_13: type_9,
member_14: type_24,
member_15: type_24,
member_16: type_24,
member_17: type_24,
member_18: type_5,
member_19: f32,
member_20: f32,
member_21: type_6,
}
struct type_26 {
member: type_25,
}
struct type_27 {
member: vec3<f32>,
member_1: vec3<f32>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_26;
@group(0) @binding(2)
var<storage, read_write> global_2: type_11;
@group(0) @binding(1)
var<storage> global_3: type_16;
fn function_() {
var phi_185_: type_14;
var phi_780_: u32;
var phi_1057_: type_27;
let _e38 = global;
let _e43 = global_1.member.member_2;
let _e46 = global_1.member.member;
let _e54 = (_e38.x + _e43.member);
let _e56 = (_e38.y + _e43.member_1);
if (_e54 < _e43.member_2) {
if (_e56 < _e43.member_3) {
let _e59 = (_e46.member * _e46.member_1);
let _e61 = ((_e56 * _e46.member) + _e54);
let _e65 = global_1.member.member_3.member;
let _e69 = global_1.member.member_3.member_1;
let _e70 = (_e54 % 16u);
let _e71 = (_e56 % 4u);
if ((_e54 < (_e65 - (_e65 % 16u))) && (_e56 < (_e69 - (_e69 % 4u)))) {
phi_185_ = type_14((((_e54 - _e70) + (_e71 * 4u)) + (_e70 % 4u)), ((_e56 - _e71) + (_e70 / 4u)));
} else {
phi_185_ = type_14(_e54, _e56);
}
let _e90 = phi_185_;
let _e104 = global_1.member.member_12.member;
let _e105 = (((((f32(bitcast<i32>(_e90.member)) + 0.5f) / f32(bitcast<i32>(_e65))) * 2f) - 1f) * _e104);
let _e117 = global_1.member.member_12.member_1;
let _e118 = ((1f - (((f32(bitcast<i32>(_e90.member_1)) + 0.5f) / f32(bitcast<i32>(_e69))) * 2f)) * _e117);
let _e122 = global_1.member.member_12.member_3;
let _e123 = (_e122 != 0u);
let _e127 = global_1.member.member_12.member_2;
let _e128 = select(_e105, 0f, _e123);
let _e129 = select(_e118, 0f, _e123);
let _e130 = select(0f, _e105, _e123);
let _e131 = select(0f, _e118, _e123);
let _e135 = (_e130 + (_e128 * _e127));
let _e136 = (_e131 + (_e129 * _e127));
let _e137 = (0f + (1f * _e127));
let _e142 = (((_e128 * _e128) + (_e129 * _e129)) + (1f * 1f));
let _e145 = sqrt(select(0f, _e142, (_e142 > 0f)));
let _e148 = (1f / select(1e-20f, _e145, (_e145 > 1e-20f)));
let _e156 = global_1.member.member_13.member.member;
let _e167 = ((((_e156.member.member * _e130) + (_e156.member.member_1 * _e131)) + (_e156.member.member_2 * 0f)) + _e156.member_1);
let _e173 = ((((_e156.member.member * _e135) + (_e156.member.member_1 * _e136)) + (_e156.member.member_2 * _e137)) + _e156.member_1);
let _e176 = ((_e167 > 0f) && (_e173 <= 0f));
let _e177 = (_e167 - _e173);
let _e180 = (_e167 / select(1e-20f, _e177, (_e177 > 1e-20f)));
let _e185 = global_1.member.member_13.member_1.member;
let _e196 = ((((_e185.member.member * _e130) + (_e185.member.member_1 * _e131)) + (_e185.member.member_2 * 0f)) + _e185.member_1);
let _e202 = ((((_e185.member.member * _e135) + (_e185.member.member_1 * _e136)) + (_e185.member.member_2 * _e137)) + _e185.member_1);
let _e205 = ((_e196 > 0f) && (_e202 <= 0f));
let _e206 = (_e196 - _e202);
let _e209 = (_e196 / select(1e-20f, _e206, (_e206 > 1e-20f)));
let _e213 = (_e205 && (!(_e176) || (_e209 < _e180)));
let _e219 = global_1.member.member_13.member_1.member.member;
let _e224 = global_1.member.member_13.member_1.member_1;
let _e230 = global_1.member.member_13.member.member.member;
let _e235 = global_1.member.member_13.member.member_1;
let _e254 = (_e176 || _e205);
let _e255 = select(_e180, _e209, _e213);
let _e260 = select(1f, _e255, (_e255 < 1f));
let _e264 = (_e130 + ((_e135 - _e130) * _e260));
let _e265 = (_e131 + ((_e136 - _e131) * _e260));
let _e266 = (0f + ((_e137 - 0f) * _e260));
let _e270 = global_1.member.member_10.member;
let _e281 = ((((_e270.member.member * _e264) + (_e270.member.member_1 * _e265)) + (_e270.member.member_2 * _e266)) + _e270.member_1);
let _e285 = global_1.member.member_10.member_1;
let _e296 = ((((_e285.member.member * _e264) + (_e285.member.member_1 * _e265)) + (_e285.member.member_2 * _e266)) + _e285.member_1);
let _e300 = global_1.member.member_10.member_2;
let _e311 = ((((_e300.member.member * _e264) + (_e300.member.member_1 * _e265)) + (_e300.member.member_2 * _e266)) + _e300.member_1);
let _e315 = global_1.member.member_10.member_3;
let _e316 = (_e315 != 0u);
let _e321 = (((_e281 * _e281) + (_e296 * _e296)) + (_e311 * _e311));
let _e324 = sqrt(select(0f, _e321, (_e321 > 0f)));
let _e327 = (1f / select(1e-20f, _e324, (_e324 > 1e-20f)));
let _e331 = select(0f, (_e281 * _e327), _e316);
let _e332 = select(0f, (_e296 * _e327), _e316);
let _e333 = select(1f, (_e311 * _e327), _e316);
let _e338 = global_1.member.member_10.member.member;
let _e349 = global_1.member.member_10.member_1.member;
let _e363 = global_1.member.member_10.member_2.member;
let _e375 = global_1.member.member_1;
let _e381 = global_1.member.member_9.member_1;
if ((_e375 & 256u) != 0u) {
let _e391 = global_1.member.member_10.member_17.member.member;
let _e392 = bitcast<i32>(_e391);
let _e398 = global_1.member.member_10.member_17.member.member_1;
let _e399 = bitcast<i32>(_e398);
let _e400 = select(1f, _e311, _e316);
let _e403 = (1f / select(1e-12f, _e400, (_e400 > 1e-12f)));
let _e408 = global_1.member.member_10.member_5;
let _e413 = global_1.member.member_10.member_8;
let _e414 = (((_e281 * _e403) - _e408) * _e413);
let _e419 = global_1.member.member_10.member_6;
let _e421 = (((_e296 * _e403) - _e419) * _e413);
let _e426 = global_1.member.member_10.member_4.member;
let _e428 = f32(bitcast<i32>(_e426));
let _e430 = select(0f, _e414, (_e414 > 0f));
let _e437 = global_1.member.member_10.member_17.member_1;
let _e440 = ((_e414 - _e428) * _e437);
let _e445 = global_1.member.member_10.member_17.member_2;
let _e447 = select(0f, _e440, (_e440 > 0f));
let _e449 = (_e445 + _e447);
let _e454 = (-(_e414) * _e437);
let _e456 = select(0f, _e454, (_e454 > 0f));
let _e458 = (_e445 + _e456);
let _e465 = (((_e445 + (select(_e428, _e430, (_e430 < _e428)) * _e437)) + (((_e447 * _e445) / select(1e-12f, _e449, (_e449 > 1e-12f))) - ((_e456 * _e445) / select(1e-12f, _e458, (_e458 > 1e-12f))))) - 0.5f);
let _e470 = global_1.member.member_10.member_4.member_1;
let _e472 = f32(bitcast<i32>(_e470));
let _e474 = select(0f, _e421, (_e421 > 0f));
let _e479 = ((_e421 - _e472) * _e437);
let _e481 = select(0f, _e479, (_e479 > 0f));
let _e483 = (_e445 + _e481);
let _e488 = (-(_e421) * _e437);
let _e490 = select(0f, _e488, (_e488 > 0f));
let _e492 = (_e445 + _e490);
let _e499 = (((_e445 + (select(_e472, _e474, (_e474 < _e472)) * _e437)) + (((_e481 * _e445) / select(1e-12f, _e483, (_e483 > 1e-12f))) - ((_e490 * _e445) / select(1e-12f, _e492, (_e492 > 1e-12f))))) - 0.5f);
let _e501 = f32((_e392 - 2i));
let _e503 = select(0f, _e465, (_e465 > 0f));
let _e505 = select(_e501, _e503, (_e503 < _e501));
let _e512 = select(0i, select(select(i32(_e505), i32(-2147483648), (_e505 < -2147483600f)), 2147483647i, (_e505 > 2147483500f)), (_e505 == _e505));
let _e516 = (_e512 - select(0i, 1i, (_e505 < f32(_e512))));
let _e518 = f32((_e399 - 2i));
let _e520 = select(0f, _e499, (_e499 > 0f));
let _e522 = select(_e518, _e520, (_e520 < _e518));
let _e529 = select(0i, select(select(i32(_e522), i32(-2147483648), (_e522 < -2147483600f)), 2147483647i, (_e522 > 2147483500f)), (_e522 == _e522));
let _e533 = (_e529 - select(0i, 1i, (_e522 < f32(_e529))));
let _e535 = (_e465 - f32(_e516));
let _e537 = select(0f, _e535, (_e535 > 0f));
let _e539 = select(1f, _e537, (_e537 < 1f));
let _e541 = (_e499 - f32(_e533));
let _e543 = select(0f, _e541, (_e541 > 0f));
let _e545 = select(1f, _e543, (_e543 < 1f));
if _e213 {
let _e550 = global_1.member.member_10.member_17.member_4;
phi_780_ = _e550;
} else {
let _e555 = global_1.member.member_10.member_17.member_3;
phi_780_ = _e555;
}
let _e557 = phi_780_;
let _e561 = ((bitcast<i32>(_e557) + (_e533 * _e392)) + _e516);
let _e562 = (_e392 * _e399);
let _e564 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e566 = select(_e564, _e561, (_e561 < _e564));
let _e572 = global_3.member[bitcast<u32>(select(0i, _e566, (_e566 > 0i)))];
let _e573 = bitcast<f32>(_e572);
let _e574 = (_e561 + 1i);
let _e576 = select(_e564, _e574, (_e574 < _e564));
let _e582 = global_3.member[bitcast<u32>(select(0i, _e576, (_e576 > 0i)))];
let _e586 = (_e573 + ((bitcast<f32>(_e582) - _e573) * _e539));
let _e587 = (_e561 + _e392);
let _e589 = select(_e564, _e587, (_e587 < _e564));
let _e595 = global_3.member[bitcast<u32>(select(0i, _e589, (_e589 > 0i)))];
let _e596 = bitcast<f32>(_e595);
let _e597 = (_e587 + 1i);
let _e599 = select(_e564, _e597, (_e597 < _e564));
let _e605 = global_3.member[bitcast<u32>(select(0i, _e599, (_e599 > 0i)))];
let _e613 = (_e561 + _e562);
let _e615 = select(_e564, _e613, (_e613 < _e564));
let _e621 = global_3.member[bitcast<u32>(select(0i, _e615, (_e615 > 0i)))];
let _e622 = bitcast<f32>(_e621);
let _e623 = (_e613 + 1i);
let _e625 = select(_e564, _e623, (_e623 < _e564));
let _e631 = global_3.member[bitcast<u32>(select(0i, _e625, (_e625 > 0i)))];
let _e635 = (_e622 + ((bitcast<f32>(_e631) - _e622) * _e539));
let _e636 = (_e613 + _e392);
let _e638 = select(_e564, _e636, (_e636 < _e564));
let _e644 = global_3.member[bitcast<u32>(select(0i, _e638, (_e638 > 0i)))];
let _e645 = bitcast<f32>(_e644);
let _e646 = (_e636 + 1i);
let _e648 = select(_e564, _e646, (_e646 < _e564));
let _e654 = global_3.member[bitcast<u32>(select(0i, _e648, (_e648 > 0i)))];
let _e663 = (_e561 + (2i * _e562));
let _e665 = select(_e564, _e663, (_e663 < _e564));
let _e671 = global_3.member[bitcast<u32>(select(0i, _e665, (_e665 > 0i)))];
let _e672 = bitcast<f32>(_e671);
let _e673 = (_e663 + 1i);
let _e675 = select(_e564, _e673, (_e673 < _e564));
let _e681 = global_3.member[bitcast<u32>(select(0i, _e675, (_e675 > 0i)))];
let _e685 = (_e672 + ((bitcast<f32>(_e681) - _e672) * _e539));
let _e686 = (_e663 + _e392);
let _e688 = select(_e564, _e686, (_e686 < _e564));
let _e694 = global_3.member[bitcast<u32>(select(0i, _e688, (_e688 > 0i)))];
let _e695 = bitcast<f32>(_e694);
let _e696 = (_e686 + 1i);
let _e698 = select(_e564, _e696, (_e696 < _e564));
let _e704 = global_3.member[bitcast<u32>(select(0i, _e698, (_e698 > 0i)))];
let _e713 = (_e316 && (_e311 <= 0f));
phi_1057_ = type_27(vec3<f32>(select((_e381.member * (_e586 + (((_e596 + ((bitcast<f32>(_e605) - _e596) * _e539)) - _e586) * _e545))), _e381.member, _e713), select((_e381.member_1 * (_e635 + (((_e645 + ((bitcast<f32>(_e654) - _e645) * _e539)) - _e635) * _e545))), _e381.member_1, _e713), select((_e381.member_2 * (_e685 + (((_e695 + ((bitcast<f32>(_e704) - _e695) * _e539)) - _e685) * _e545))), _e381.member_2, _e713)), (vec3<f32>(((_e338.member * _e331) + (_e349.member * _e332)), ((_e338.member_1 * _e331) + (_e349.member_1 * _e332)), ((_e338.member_2 * _e331) + (_e349.member_2 * _e332))) + vec3<f32>((_e363.member * _e333), (_e363.member_1 * _e333), (_e363.member_2 * _e333))));
} else {
let _e725 = global_1.member.member_9.member;
phi_1057_ = type_27(vec3<f32>(_e381.member, _e381.member_1, _e381.member_2), vec3<f32>(_e725.member, _e725.member_1, _e725.member_2));
}
let _e732 = phi_1057_;
let _e741 = (((_e732.member_1.x * _e732.member_1.x) + (_e732.member_1.y * _e732.member_1.y)) + (_e732.member_1.z * _e732.member_1.z));
let _e744 = sqrt(select(0f, _e741, (_e741 > 0f)));
let _e750 = (1e-6f * _e744);
let _e754 = select((_e744 / select(_e750, _e732.member_1.z, (_e732.member_1.z > _e750))), 1f, ((_e375 & 8u) != 0u));
let _e763 = global_1.member.member_18;
let _e775 = (-((((select(_e230.member, _e219.member, _e213) * _e732.member_1.x) + (select(_e230.member_1, _e219.member_1, _e213) * _e732.member_1.y)) + (select(_e230.member_2, _e219.member_2, _e213) * _e732.member_1.z))) / select(1e-20f, _e744, (_e744 > 1e-20f)));
let _e780 = bitcast<f32>((bitcast<u32>(select(0f, _e775, (_e775 > 0f))) & 2147483647u));
let _e790 = select(0f, 1f, _e254);
global_2.member[_e61] = _e135;
global_2.member[(_e59 + _e61)] = _e136;
global_2.member[((2u * _e59) + _e61)] = _e137;
global_2.member[((3u * _e59) + _e61)] = (_e128 * _e148);
global_2.member[((4u * _e59) + _e61)] = (_e129 * _e148);
global_2.member[((5u * _e59) + _e61)] = (1f * _e148);
global_2.member[((6u * _e59) + _e61)] = 0f;
global_2.member[((7u * _e59) + _e61)] = _e790;
global_2.member[((8u * _e59) + _e61)] = select(0f, (_e255 * _e127), _e254);
global_2.member[((9u * _e59) + _e61)] = select(0f, (select(_e235.member, _e224.member, _e213) * (((_e732.member.x * _e754) * _e780) + _e763.member)), _e254);
global_2.member[((10u * _e59) + _e61)] = select(0f, (select(_e235.member_1, _e224.member_1, _e213) * (((_e732.member.y * _e754) * _e780) + _e763.member_1)), _e254);
global_2.member[((11u * _e59) + _e61)] = select(0f, (select(_e235.member_2, _e224.member_2, _e213) * (((_e732.member.z * _e754) * _e780) + _e763.member_2)), _e254);
global_2.member[((12u * _e59) + _e61)] = _e790;
global_2.member[((13u * _e59) + _e61)] = 1f;
global_2.member[((14u * _e59) + _e61)] = 1f;
global_2.member[((15u * _e59) + _e61)] = 1f;
global_2.member[((16u * _e59) + _e61)] = 0f;
global_2.member[((17u * _e59) + _e61)] = -1.2676506e30f;
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
